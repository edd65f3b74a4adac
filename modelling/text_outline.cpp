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

#include "modelling/font_file.hpp"

namespace raycat {
namespace {

// OpenSCAD loads glyphs at 1562.5 points and 100 dots to the inch, in 64ths of a dot, and makes
// 100 000 of those one unit of size. It divides what it places them by, though not the glyphs, by
// 1024 where 1000 was meant, so that text is a little narrower than the font would have it.
constexpr FT_F26Dot6 char_size = 100'000;
constexpr unsigned dots_per_inch = 100;
constexpr double placing = 1000.0 / 1024.0;

// A font, with all that must go when it goes.
class Font {
 public:
  explicit Font(const std::string& pattern) {
    const FontFile file = font_file(pattern.empty() ? "Liberation Sans" : pattern);
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    if (FT_Init_FreeType(&library) != 0) {
      throw std::runtime_error("FreeType does not start");
    }
    library_.reset(library);
    if (FT_New_Face(library, file.path.c_str(), file.index, &face) != 0) {
      throw std::runtime_error(fmt::format("FreeType cannot read {}", file.path));
    }
    face_.reset(face);
    if (FT_Set_Char_Size(face, 0, char_size, dots_per_inch, dots_per_inch) != 0) {
      throw std::runtime_error(fmt::format("FreeType cannot scale {}", file.path));
    }
    shaped_.reset(hb_ft_font_create(face, nullptr));
  }

  hb_font_t* shaped() const { return shaped_.get(); }

  const FT_Outline& outline(hb_codepoint_t glyph) const {
    if (FT_Load_Glyph(face_.get(), glyph, FT_LOAD_DEFAULT) != 0 ||
        face_->glyph->format != FT_GLYPH_FORMAT_OUTLINE) {
      throw std::runtime_error(fmt::format("a font has no outline of its glyph {}", glyph));
    }
    return face_->glyph->outline;
  }

 private:
  std::unique_ptr<FT_LibraryRec_, decltype(&FT_Done_FreeType)> library_{nullptr, &FT_Done_FreeType};
  std::unique_ptr<FT_FaceRec_, decltype(&FT_Done_Face)> face_{nullptr, &FT_Done_Face};
  std::unique_ptr<hb_font_t, decltype(&hb_font_destroy)> shaped_{nullptr, &hb_font_destroy};
};

using Buffer = std::unique_ptr<hb_buffer_t, decltype(&hb_buffer_destroy)>;

Buffer shape(const std::string& text, const TextStyle& style, const Font& font) {
  Buffer buffer(hb_buffer_create(), &hb_buffer_destroy);
  hb_buffer_add_utf8(buffer.get(), text.c_str(), static_cast<int>(text.size()), 0, -1);
  hb_buffer_set_direction(buffer.get(), hb_direction_from_string(style.direction.c_str(), -1));
  hb_buffer_set_script(buffer.get(), hb_script_from_string(style.script.c_str(), -1));
  hb_buffer_set_language(buffer.get(), hb_language_from_string(style.language.c_str(), -1));
  hb_buffer_guess_segment_properties(buffer.get());
  hb_shape(font.shaped(), buffer.get(), nullptr, 0);
  return buffer;
}

glm::dvec2 point(const FT_Vector& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

// The contours of a glyph in 64ths of a dot, each curve in as many pieces.
class Tracer {
 public:
  explicit Tracer(std::uint32_t pieces) : pieces_(pieces) {}

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
    if (FT_Outline_Decompose(&copy, &steps, this) != 0) {
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
  std::vector<Contour> contours_;
};

// How far text reaches, as its alignment sees it: along the line by advances, across it by the
// glyphs' boxes in whole dots.
struct Extent {
  double width = 0.0;
  double ascent = 0.0;
  double descent = 0.0;

  void include(const FT_Outline& outline, const glm::dvec2& advance, bool horizontal) {
    FT_BBox box;
    FT_Outline_Get_CBox(&outline, &box);
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

std::vector<Placed> place(hb_buffer_t* buffer, const TextStyle& style, const Font& font) {
  unsigned count = 0;
  const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer, &count);
  const hb_glyph_position_t* positions = hb_buffer_get_glyph_positions(buffer, &count);
  const bool horizontal = HB_DIRECTION_IS_HORIZONTAL(hb_buffer_get_direction(buffer));
  std::vector<Placed> out;
  Extent extent;
  glm::dvec2 pen(0.0);
  for (unsigned i = 0; i < count; ++i) {
    const hb_glyph_position_t& p = positions[i];
    const glm::dvec2 advance = style.spacing * glm::dvec2(p.x_advance, p.y_advance);
    out.push_back({infos[i].codepoint, pen + glm::dvec2(p.x_offset, p.y_offset)});
    extent.include(font.outline(infos[i].codepoint), advance, horizontal);
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
  const Font font(style.font);
  const Buffer buffer = shape(text, style, font);
  const double scale = style.size / static_cast<double>(char_size);
  Tracer tracer(std::max(style.facets / 8 + 1, 2U));
  std::vector<Polygons> glyphs;
  for (const Placed& placed : place(buffer.get(), style, font)) {
    const Polygons glyph = even_odd(tracer.trace(font.outline(placed.glyph)));
    glyphs.push_back(transformed(glyph, {{scale, 0.0}, {0.0, scale}, scale * placed.origin}));
  }
  return combined(Operation::set_union, glyphs);
}

}  // namespace raycat
