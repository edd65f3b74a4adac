#include "modelling/font_file.hpp"

#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <fontconfig/fontconfig.h>

namespace raycat {
namespace {

using Pattern = std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)>;
using Config = std::unique_ptr<FcConfig, decltype(&FcConfigDestroy)>;

const FcChar8* characters(const std::string& text) {
  return reinterpret_cast<const FcChar8*>(text.c_str());
}

bool is_of_family(const FcPattern* font, const FcChar8* family) {
  FcChar8* name = nullptr;
  for (int i = 0; FcPatternGetString(font, FC_FAMILY, i, &name) == FcResultMatch; ++i) {
    if (FcStrCmpIgnoreCase(name, family) == 0) {
      return true;
    }
  }
  return false;
}

}  // namespace

FontFile font_file(const std::string& pattern) {
  const Config config(FcInitLoadConfigAndFonts(), &FcConfigDestroy);
  const Pattern wanted(FcNameParse(characters(pattern)), &FcPatternDestroy);
  FcChar8* family = nullptr;
  if (!config || !wanted ||
      FcPatternGetString(wanted.get(), FC_FAMILY, 0, &family) != FcResultMatch) {
    throw std::runtime_error(fmt::format("\"{}\" names no font", pattern));
  }
  const std::string name = reinterpret_cast<const char*>(family);
  FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
  FcConfigSubstitute(config.get(), wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const Pattern font(FcFontMatch(config.get(), wanted.get(), &result), &FcPatternDestroy);
  FcChar8* path = nullptr;
  if (!font || !is_of_family(font.get(), characters(name)) ||
      FcPatternGetString(font.get(), FC_FILE, 0, &path) != FcResultMatch) {
    throw std::runtime_error(fmt::format("the font \"{}\" is not on this machine", name));
  }
  FontFile out{.path = reinterpret_cast<const char*>(path)};
  FcPatternGetInteger(font.get(), FC_INDEX, 0, &out.index);
  return out;
}

}  // namespace raycat
