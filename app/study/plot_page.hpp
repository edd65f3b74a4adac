#pragma once

#include <memory>
#include <span>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace raycat {

/// A white page to draw on that becomes the bytes of an SVG or a PNG file, the same each time.
/// Places are pixels from the top left corner, colours sRGB.
class PlotPage {
 public:
  enum class Kind { svg, png };
  enum class Align { start, middle, end };

  PlotPage(Kind kind, int width, int height);
  ~PlotPage();
  PlotPage(const PlotPage&) = delete;
  PlotPage& operator=(const PlotPage&) = delete;

  void line(std::span<const glm::dvec2> points, const glm::dvec3& colour, double width,
            bool dashed = false);

  /// Closed, and filled with its colour, or white and outlined with it if `hollow`.
  void polygon(std::span<const glm::dvec2> corners, const glm::dvec3& colour, bool hollow);

  /// Black, from, around or up to `at`; running upwards if `upright`. What is not ASCII is shown
  /// as question marks.
  void text(const glm::dvec2& at, const std::string& words, Align align, double size,
            bool upright = false);

  /// The file. Nothing can be drawn any more. Throws `std::runtime_error` if drawing failed.
  std::string finish();

 private:
  struct Cairo;
  std::unique_ptr<Cairo> cairo_;
};

}  // namespace raycat
