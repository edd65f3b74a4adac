#include "modelling/font_file.hpp"

#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <fontconfig/fontconfig.h>

#include "dynamic/shared_library.hpp"

namespace raycat {
namespace {

struct Fontconfig {
  SharedLibrary library{"libfontconfig.so.1"};
  decltype(FcInitLoadConfigAndFonts)* load = library["FcInitLoadConfigAndFonts"];
  decltype(FcConfigDestroy)* destroy_config = library["FcConfigDestroy"];
  decltype(FcConfigSubstitute)* substitute = library["FcConfigSubstitute"];
  decltype(FcDefaultSubstitute)* substitute_defaults = library["FcDefaultSubstitute"];
  decltype(FcFontMatch)* match = library["FcFontMatch"];
  decltype(FcNameParse)* parse = library["FcNameParse"];
  decltype(FcPatternAddBool)* add_bool = library["FcPatternAddBool"];
  decltype(FcPatternDestroy)* destroy_pattern = library["FcPatternDestroy"];
  decltype(FcPatternGetInteger)* integer = library["FcPatternGetInteger"];
  decltype(FcPatternGetString)* string = library["FcPatternGetString"];
  decltype(FcStrCmpIgnoreCase)* compare = library["FcStrCmpIgnoreCase"];
};

using Pattern = std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)>;
using Config = std::unique_ptr<FcConfig, decltype(&FcConfigDestroy)>;

const FcChar8* characters(const std::string& text) {
  return reinterpret_cast<const FcChar8*>(text.c_str());
}

bool is_of_family(const Fontconfig& fc, const FcPattern* font, const FcChar8* family) {
  FcChar8* name = nullptr;
  for (int i = 0; fc.string(font, FC_FAMILY, i, &name) == FcResultMatch; ++i) {
    if (fc.compare(name, family) == 0) {
      return true;
    }
  }
  return false;
}

}  // namespace

FontFile font_file(const std::string& pattern) {
  const Fontconfig fc;
  const Config config(fc.load(), fc.destroy_config);
  const Pattern wanted(fc.parse(characters(pattern)), fc.destroy_pattern);
  FcChar8* family = nullptr;
  if (!config || !wanted || fc.string(wanted.get(), FC_FAMILY, 0, &family) != FcResultMatch) {
    throw std::runtime_error(fmt::format("\"{}\" names no font", pattern));
  }
  const std::string name = reinterpret_cast<const char*>(family);
  fc.add_bool(wanted.get(), FC_SCALABLE, FcTrue);
  fc.substitute(config.get(), wanted.get(), FcMatchPattern);
  fc.substitute_defaults(wanted.get());
  FcResult result = FcResultNoMatch;
  const Pattern font(fc.match(config.get(), wanted.get(), &result), fc.destroy_pattern);
  FcChar8* path = nullptr;
  if (!font || !is_of_family(fc, font.get(), characters(name)) ||
      fc.string(font.get(), FC_FILE, 0, &path) != FcResultMatch) {
    throw std::runtime_error(fmt::format("the font \"{}\" is not on this machine", name));
  }
  FontFile out{.path = reinterpret_cast<const char*>(path)};
  fc.integer(font.get(), FC_INDEX, 0, &out.index);
  return out;
}

}  // namespace raycat
