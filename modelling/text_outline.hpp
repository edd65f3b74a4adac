#pragma once

#include <cstdint>
#include <string>

#include "modelling/polygons.hpp"

namespace raycat {

/// OpenSCAD's text(), with its names.
struct TextStyle {
  std::string font;  ///< a fontconfig pattern such as `DejaVu Sans:style=Bold`
  double size = 10.0;
  double spacing = 1.0;
  std::string direction = "ltr";      ///< ltr, rtl, ttb or btt
  std::string horizontal = "left";    ///< left, center or right
  std::string vertical = "baseline";  ///< top, center, baseline or bottom
  std::string language = "en";
  std::string script = "Latn";
  std::uint32_t facets = 30;  ///< of a circle of radius `size`; curves of glyphs take an eighth
};

/// The outlines of UTF-8 text. A font named "" is Liberation Sans. Throws `std::runtime_error` if
/// the machine lacks the font's family (fontconfig would take another), or FreeType cannot read it.
Polygons text_outline(const std::string& text, const TextStyle& style);

}  // namespace raycat
