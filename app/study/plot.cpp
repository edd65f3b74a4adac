#include "app/study/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "app/study/plot_page.hpp"
#include "io/files/output_file.hpp"

namespace raycat {
namespace {

constexpr int width = 800;
constexpr int height = 600;
constexpr double left = 84.0;
constexpr double right = 770.0;
constexpr double top = 48.0;
constexpr double text_size = 14.0;
constexpr double legend_line = 20.0;
constexpr std::size_t legend_columns = 2;

struct Style {
  glm::dvec3 colour;
  int corners;  // of the marker
  double turn;  // of its first corner, anticlockwise from the right, in turns
};

// Okabe and Ito's colours, without the yellow that a white page drowns.
constexpr std::array<Style, 7> styles{{{{0.000, 0.447, 0.698}, 24, 0.0},
                                       {{0.835, 0.369, 0.000}, 4, 0.125},
                                       {{0.000, 0.620, 0.451}, 3, 0.25},
                                       {{0.800, 0.475, 0.655}, 4, 0.0},
                                       {{0.000, 0.000, 0.000}, 3, 0.75},
                                       {{0.902, 0.624, 0.000}, 5, 0.25},
                                       {{0.337, 0.706, 0.914}, 6, 0.0}}};

const Style& style_of(const PlotSeries& series) {
  return styles[static_cast<std::size_t>(series.style) % styles.size()];
}

void require_points(const Plot& plot) {
  if (plot.series.empty()) {
    throw std::invalid_argument(fmt::format("plot '{}': there is no series", plot.title));
  }
  for (const PlotSeries& series : plot.series) {
    if (series.points.empty()) {
      throw std::invalid_argument(
          fmt::format("plot '{}': series '{}' has no points", plot.title, series.name));
    }
    for (const glm::dvec2& point : series.points) {
      if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
        throw std::invalid_argument(fmt::format("plot '{}': series '{}': ({}, {}) is not finite",
                                                plot.title, series.name, point.x, point.y));
      }
    }
  }
}

PlotScale scale_of(const Plot& plot, const PlotAxis& axis, double glm::dvec2::*coordinate) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const PlotSeries& series : plot.series) {
    for (const glm::dvec2& point : series.points) {
      low = std::min(low, point.*coordinate);
      high = std::max(high, point.*coordinate);
    }
  }
  return PlotScale(axis.scale, low, high);
}

class Drawing {
 public:
  Drawing(PlotPage& page, const Plot& plot)
      : page_(page),
        plot_(plot),
        x_(scale_of(plot, plot.x, &glm::dvec2::x)),
        y_(scale_of(plot, plot.y, &glm::dvec2::y)),
        bottom_(height - 60.0 -
                legend_line * std::ceil(static_cast<double>(plot.series.size()) / legend_columns)) {
  }

  void draw() {
    draw_axes();
    for (const PlotSeries& series : plot_.series) {
      std::vector<glm::dvec2> line;
      for (const glm::dvec2& point : series.points) {
        line.push_back(place(point));
      }
      page_.line(line, style_of(series).colour, 2.0, series.dashed);
    }
    for (const PlotSeries& series : plot_.series) {
      for (const glm::dvec2& point : series.points) {
        draw_marker(series, place(point));
      }
    }
    draw_legend();
  }

 private:
  using Align = PlotPage::Align;

  glm::dvec2 place(const glm::dvec2& point) const { return {place_x(point.x), place_y(point.y)}; }
  double place_x(double x) const { return left + (right - left) * x_.place(x); }
  double place_y(double y) const { return bottom_ + (top - bottom_) * y_.place(y); }

  void rule(const glm::dvec2& from, const glm::dvec2& to, double grey) {
    const std::array<glm::dvec2, 2> ends{from, to};
    page_.line(ends, glm::dvec3(grey), 1.0);
  }

  void draw_axes() {
    for (const double tick : x_.ticks()) {
      const double x = std::round(place_x(tick)) + 0.5;  // on a column of pixels
      rule({x, top}, {x, bottom_}, 0.88);
      page_.text({x, bottom_ + 18}, fmt::format("{:g}", tick), Align::middle, text_size);
    }
    for (const double tick : y_.ticks()) {
      const double y = std::round(place_y(tick)) + 0.5;
      rule({left, y}, {right, y}, 0.88);
      page_.text({left - 8, y + 5}, fmt::format("{:g}", tick), Align::end, text_size);
    }
    rule({left + 0.5, top}, {left + 0.5, bottom_}, 0.3);
    rule({left, bottom_ + 0.5}, {right, bottom_ + 0.5}, 0.3);
    page_.text({width / 2.0, 28}, plot_.title, Align::middle, 17);
    page_.text({(left + right) / 2, bottom_ + 40}, plot_.x.label, Align::middle, text_size);
    page_.text({22, (top + bottom_) / 2}, plot_.y.label, Align::middle, text_size, true);
  }

  void draw_marker(const PlotSeries& series, const glm::dvec2& at) {
    if (!series.marked) {
      return;
    }
    const Style& style = style_of(series);
    const double radius = style.corners > 6 ? 4.0 : 5.0;
    std::vector<glm::dvec2> corners;
    for (int i = 0; i < style.corners; ++i) {
      const double angle =
          2 * std::numbers::pi * (style.turn + i / static_cast<double>(style.corners));
      corners.push_back(at + radius * glm::dvec2(std::cos(angle), -std::sin(angle)));
    }
    page_.polygon(corners, style.colour, series.dashed);
  }

  void draw_legend() {
    for (std::size_t i = 0; i < plot_.series.size(); ++i) {
      const PlotSeries& series = plot_.series[i];
      const auto column = static_cast<double>(i % legend_columns);
      const std::size_t row = i / legend_columns;
      const glm::dvec2 at(left + column * (right - left) / legend_columns,
                          bottom_ + 60 + legend_line * static_cast<double>(row));
      const std::array<glm::dvec2, 2> ends{at, at + glm::dvec2(36, 0)};
      page_.line(ends, style_of(series).colour, 2.0, series.dashed);
      draw_marker(series, at + glm::dvec2(18, 0));
      page_.text(at + glm::dvec2(44, 5), series.name, Align::start, text_size);
    }
  }

  PlotPage& page_;
  const Plot& plot_;
  PlotScale x_;
  PlotScale y_;
  double bottom_;
};

}  // namespace

void write_plot(const std::filesystem::path& path, const Plot& plot) {
  const std::string extension = path.extension().string();
  if (extension != ".svg" && extension != ".png") {
    throw std::invalid_argument(fmt::format("{}: plots end in .svg or .png", path.string()));
  }
  require_points(plot);
  PlotPage page(extension == ".svg" ? PlotPage::Kind::svg : PlotPage::Kind::png, width, height);
  Drawing(page, plot).draw();
  write_file(path, page.finish());
}

}  // namespace raycat
