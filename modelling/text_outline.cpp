#include "modelling/text_outline.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <ft2build.h>
#include <hb-ft.h>
#include <hb.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "dynamic/shared_library.hpp"
#include "modelling/font_file.hpp"

namespace raycat {
namespace {

struct FreeType {
  SharedLibrary library{"libfreetype.so.6"};
  decltype(FT_Init_FreeType)* start = library["FT_Init_FreeType"];
  decltype(FT_Done_FreeType)* end = library["FT_Done_FreeType"];
  decltype(FT_New_Face)* open = library["FT_New_Face"];
  decltype(FT_Done_Face)* close = library["FT_Done_Face"];
  decltype(FT_Set_Char_Size)* set_size = library["FT_Set_Char_Size"];
  decltype(FT_Load_Glyph)* load = library["FT_Load_Glyph"];
  decltype(FT_Outline_Decompose)* decompose = library["FT_Outline_Decompose"];
  decltype(FT_Outline_Get_CBox)* box = library["FT_Outline_Get_CBox"];
};

struct HarfBuzz {
  SharedLibrary library{"libharfbuzz.so.0"};
  decltype(hb_ft_font_create)* font = library["hb_ft_font_create"];
  decltype(hb_font_destroy)* destroy_font = library["hb_font_destroy"];
  decltype(hb_buffer_create)* buffer = library["hb_buffer_create"];
  decltype(hb_buffer_destroy)* destroy_buffer = library["hb_buffer_destroy"];
  decltype(hb_buffer_add_utf8)* add = library["hb_buffer_add_utf8"];
  decltype(hb_buffer_set_direction)* set_direction = library["hb_buffer_set_direction"];
  decltype(hb_buffer_set_script)* set_script = library["hb_buffer_set_script"];
  decltype(hb_buffer_set_language)* set_language = library["hb_buffer_set_language"];
  decltype(hb_buffer_guess_segment_properties)* guess =
      library["hb_buffer_guess_segment_properties"];
  decltype(hb_buffer_get_direction)* direction = library["hb_buffer_get_direction"];
  decltype(hb_buffer_get_glyph_infos)* glyphs = library["hb_buffer_get_glyph_infos"];
  decltype(hb_buffer_get_glyph_positions)* positions = library["hb_buffer_get_glyph_positions"];
  decltype(hb_direction_from_string)* direction_of = library["hb_direction_from_string"];
  decltype(hb_script_from_string)* script_of = library["hb_script_from_string"];
  decltype(hb_language_from_string)* language_of = library["hb_language_from_string"];
  decltype(hb_shape)* shape = library["hb_shape"];
};

// OpenSCAD loads glyphs at 1562.5 points and 100 dots to the inch, in 64ths of a dot, and makes
// 100 000 of those one unit of size. It divides what it places them by, though not the glyphs, by
// 1024 where 1000 was meant, so that text is a little narrower than the font would have it.
constexpr FT_F26Dot6 char_size = 100'000;
constexpr unsigned dots_per_inch = 100;
constexpr double placing = 1000.0 / 1024.0;

// A font, with all that must go when it goes.
class Font {
 public:
  Font(const std::string& pattern, const FreeType& freetype, const HarfBuzz& harfbuzz)
      : freetype_(freetype),
        library_(nullptr, freetype.end),
        face_(nullptr, freetype.close),
        shaped_(nullptr, harfbuzz.destroy_font) {
    const FontFile file = font_file(pattern.empty() ? "Liberation Sans" : pattern);
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    if (freetype.start(&library) != 0) {
      throw std::runtime_error("FreeType does not start");
    }
    library_.reset(library);
    if (freetype.open(library, file.path.c_str(), file.index, &face) != 0) {
      throw std::runtime_error(fmt::format("FreeType cannot read {}", file.path));
    }
    face_.reset(face);
    if (freetype.set_size(face, 0, char_size, dots_per_inch, dots_per_inch) != 0) {
      throw std::runtime_error(fmt::format("FreeType cannot scale {}", file.path));
    }
    shaped_.reset(harfbuzz.font(face, nullptr));
  }

  hb_font_t* shaped() const { return shaped_.get(); }

  const FT_Outline& outline(hb_codepoint_t glyph) const {
    if (freetype_.load(face_.get(), glyph, FT_LOAD_DEFAULT) != 0 ||
        face_->glyph->format != FT_GLYPH_FORMAT_OUTLINE) {
      throw std::runtime_error(fmt::format("a font has no outline of its glyph {}", glyph));
    }
    return face_->glyph->outline;
  }

  FT_BBox box(hb_codepoint_t glyph) const {
    FT_BBox box;
    freetype_.box(&outline(glyph), &box);
    return box;
  }

 private:
  const FreeType& freetype_;
  std::unique_ptr<FT_LibraryRec_, decltype(&FT_Done_FreeType)> library_;
  std::unique_ptr<FT_FaceRec_, decltype(&FT_Done_Face)> face_;
  std::unique_ptr<hb_font_t, decltype(&hb_font_destroy)> shaped_;
};

using Buffer = std::unique_ptr<hb_buffer_t, decltype(&hb_buffer_destroy)>;

Buffer shape(const std::string& text, const TextStyle& style, const Font& font,
             const HarfBuzz& harfbuzz) {
  Buffer buffer(harfbuzz.buffer(), harfbuzz.destroy_buffer);
  harfbuzz.add(buffer.get(), text.c_str(), static_cast<int>(text.size()), 0, -1);
  harfbuzz.set_direction(buffer.get(), harfbuzz.direction_of(style.direction.c_str(), -1));
  harfbuzz.set_script(buffer.get(), harfbuzz.script_of(style.script.c_str(), -1));
  harfbuzz.set_language(buffer.get(), harfbuzz.language_of(style.language.c_str(), -1));
  harfbuzz.guess(buffer.get());
  harfbuzz.shape(font.shaped(), buffer.get(), nullptr, 0);
  return buffer;
}

glm::dvec2 point(const FT_Vector& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

// The contours of a glyph in 64ths of a dot, each curve in as many pieces.
class Tracer {
 public:
  Tracer(std::uint32_t pieces, const FreeType& freetype) : pieces_(pieces), freetype_(freetype) {}

  std::vector<Contour> trace(const FT_Outline& outline) {
    contours_.clear();
    FT_Outline_Funcs steps{};
    steps.move_to = [](const FT_Vector* to, void* self) {
      static_cast<Tracer*>(self)->contours_.push_back({point(*to)});
      return 0;
    };
    steps.line_to = [](const FT_Vector* to, void* self) {
      static_cast<Tracer*>(self)->contours_.back().push_back(point(*to));
      return 0;
    };
    steps.conic_to = [](const FT_Vector* c, const FT_Vector* to, void* self) {
      const glm::dvec2 middle = point(*c);
      const glm::dvec2 end = point(*to);
      static_cast<Tracer*>(self)->curve([=](const glm::dvec2& start, double t) {
        const double s = 1.0 - t;
        return s * s * start + 2.0 * s * t * middle + t * t * end;
      });
      return 0;
    };
    steps.cubic_to = [](const FT_Vector* c, const FT_Vector* d, const FT_Vector* to, void* self) {
      const glm::dvec2 first = point(*c);
      const glm::dvec2 second = point(*d);
      const glm::dvec2 end = point(*to);
      static_cast<Tracer*>(self)->curve([=](const glm::dvec2& start, double t) {
        const double s = 1.0 - t;
        return s * s * s * start + 3.0 * s * s * t * first + 3.0 * s * t * t * second +
               t * t * t * end;
      });
      return 0;
    };
    FT_Outline copy = outline;  // FreeType reads it alone, but asks for one it could write
    if (freetype_.decompose(&copy, &steps, this) != 0) {
      throw std::runtime_error("a font has an outline that is no outline");
    }
    return std::move(contours_);
  }

 private:
  template <typename At>
  void curve(At at) {
    Contour& contour = contours_.back();
    const glm::dvec2 start = contour.back();
    for (std::uint32_t i = 1; i <= pieces_; ++i) {
      contour.push_back(at(start, static_cast<double>(i) / pieces_));
    }
  }

  std::uint32_t pieces_;
  const FreeType& freetype_;
  std::vector<Contour> contours_;
};

// How far text reaches, as its alignment sees it: along the line by advances, across it by the
// glyphs' boxes in whole dots.
struct Extent {
  double width = 0.0;
  double ascent = 0.0;
  double descent = 0.0;

  void include(const FT_BBox& box, const glm::dvec2& advance, bool horizontal) {
    const auto down = [](FT_Pos v) { return static_cast<double>(v & ~FT_Pos{63}); };
    const auto up = [](FT_Pos v) { return static_cast<double>((v + 63) & ~FT_Pos{63}); };
    if (horizontal) {
      width += advance.x;
      ascent = std::max(ascent, up(box.yMax));
      descent = std::min(descent, down(box.yMin));
    } else {
      width = std::max(width, up(box.xMax) - down(box.xMin));
      ascent += advance.y;
    }
  }

  glm::dvec2 shift(const TextStyle& style) const {
    const double x =
        style.horizontal == "right" ? -width : (style.horizontal == "center" ? -0.5 * width : 0.0);
    const double y = style.vertical == "top"      ? -ascent
                     : style.vertical == "center" ? -0.5 * (ascent + descent)
                     : style.vertical == "bottom" ? -descent
                                                  : 0.0;
    return {x, y};
  }
};

// Where a glyph's origin comes to lie, and which glyph.
struct Placed {
  hb_codepoint_t glyph;
  glm::dvec2 origin;
};

std::vector<Placed> place(hb_buffer_t* buffer, const TextStyle& style, const Font& font,
                          const HarfBuzz& harfbuzz) {
  unsigned count = 0;
  const hb_glyph_info_t* infos = harfbuzz.glyphs(buffer, &count);
  const hb_glyph_position_t* positions = harfbuzz.positions(buffer, &count);
  const bool horizontal = HB_DIRECTION_IS_HORIZONTAL(harfbuzz.direction(buffer));
  std::vector<Placed> out;
  Extent extent;
  glm::dvec2 pen(0.0);
  for (unsigned i = 0; i < count; ++i) {
    const hb_glyph_position_t& p = positions[i];
    const glm::dvec2 advance = style.spacing * glm::dvec2(p.x_advance, p.y_advance);
    out.push_back({infos[i].codepoint, pen + glm::dvec2(p.x_offset, p.y_offset)});
    extent.include(font.box(infos[i].codepoint), advance, horizontal);
    pen += advance;
  }
  const glm::dvec2 shift = extent.shift(style);
  for (Placed& placed : out) {
    placed.origin = placing * (placed.origin + shift);
  }
  return out;
}

}  // namespace

Polygons text_outline(const std::string& text, const TextStyle& style) {
  const FreeType freetype;
  const HarfBuzz harfbuzz;
  const Font font(style.font, freetype, harfbuzz);
  const Buffer buffer = shape(text, style, font, harfbuzz);
  const double scale = style.size / static_cast<double>(char_size);
  Tracer tracer(std::max(style.facets / 8 + 1, 2U), freetype);
  std::vector<Polygons> glyphs;
  for (const Placed& placed : place(buffer.get(), style, font, harfbuzz)) {
    const Polygons glyph = even_odd(tracer.trace(font.outline(placed.glyph)));
    glyphs.push_back(transformed(glyph, {{scale, 0.0}, {0.0, scale}, scale * placed.origin}));
  }
  return combined(Operation::set_union, glyphs);
}

}  // namespace raycat
