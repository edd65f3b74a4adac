#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/study/plot_scale.hpp"

namespace raycat {

struct PlotAxis {
  std::string label;
  AxisScale scale = AxisScale::linear;
};

/// Points in the order they are joined.
struct PlotSeries {
  std::string name;
  std::vector<glm::dvec2> points;
  int style = 0;  ///< colour and marker, of seven that colour-blind readers tell apart, in a cycle
  bool dashed = false;
  bool marked = true;  ///< with a marker at each point
};

/// A line plot. Its words are ASCII; other characters are shown as question marks.
struct Plot {
  std::string title;
  PlotAxis x;
  PlotAxis y;
  std::vector<PlotSeries> series;
};

/// Writes `plot`, 800 x 600, as what the extension of `path` says, .svg or .png. The file has the
/// same bytes each time, and is there whole or not at all. Throws `std::invalid_argument` for
/// another extension, a plot without series, a series without points, and points that are not
/// finite or that a logarithmic axis cannot show; `std::runtime_error` if it cannot be written.
void write_plot(const std::filesystem::path& path, const Plot& plot);

}  // namespace raycat
