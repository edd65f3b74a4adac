#include "app/study/plot.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "support/png_pixels.hpp"

namespace raycat {
namespace {

namespace fs = std::filesystem;

fs::path temporary(const std::string& name) {
  return fs::temp_directory_path() / (std::to_string(::getpid()) + name);
}

std::string text_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::string written(const std::string& extension, const Plot& plot) {
  const fs::path path = temporary("plot" + extension);
  write_plot(path, plot);
  const std::string text = text_of(path);
  fs::remove(path);
  return text;
}

using Colour = std::array<std::uint8_t, 3>;

// The styles 0 and 1.
constexpr Colour blue{0, 114, 178};
constexpr Colour vermilion{213, 94, 0};

struct Pixels {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;

  Colour at(int x, int y) const {
    const auto i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(x));
    return {bytes[i], bytes[i + 1], bytes[i + 2]};
  }

  // Where `colour` is above the row `end`: how often, and the mean and bounds of the places.
  struct Ink {
    int count = 0;
    double x = 0.0;
    double y = 0.0;
    int left = 1 << 20;
    int right = -1;
    int top = 1 << 20;
    int bottom = -1;
  };
  Ink ink(const Colour& colour, int begin, int end) const {
    Ink found;
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < width; ++x) {
        const Colour here = at(x, y);
        bool same = true;
        for (std::size_t i = 0; i < 3; ++i) {
          same = same && std::abs(here[i] - colour[i]) <= 3;
        }
        if (same) {
          ++found.count;
          found.x += x;
          found.y += y;
          found.left = std::min(found.left, x);
          found.right = std::max(found.right, x);
          found.top = std::min(found.top, y);
          found.bottom = std::max(found.bottom, y);
        }
      }
    }
    found.x /= std::max(1, found.count);
    found.y /= std::max(1, found.count);
    return found;
  }
};

Pixels drawn(const Plot& plot) {
  const fs::path path = temporary("ink.png");
  write_plot(path, plot);
  PngPixels png = png_pixels(path);
  REQUIRE_FALSE(png.alpha);
  fs::remove(path);
  return {.width = png.width, .height = png.height, .bytes = std::move(png.bytes)};
}

constexpr int legend = 560;  // rows of the legend begin below

Plot sample() {
  return {.title = "Edges <by> size",
          .x = {.label = "n & m", .scale = AxisScale::binary},
          .y = {.label = "share"},
          .series = {{.name = "a < b", .points = {{64, 0}, {128, 5}, {1024, 10}}},
                     {.name = "glass & mirrors", .points = {{256, 5}}, .style = 1}}};
}

TEST_CASE("the marks of a plot are where its axes say", "[io][plot]") {
  const Pixels pixels = drawn(sample());
  CHECK(pixels.width == 800);
  CHECK(pixels.height == 600);
  // The first series goes from corner to corner of the plot. 256 is halfway from 64 to 1024 in
  // factors of two, and 5 halfway from 0 to 10.
  const Pixels::Ink corners = pixels.ink(blue, 0, legend);
  const Pixels::Ink mark = pixels.ink(vermilion, 0, legend);
  REQUIRE(corners.count > 500);
  REQUIRE(mark.count > 30);
  CHECK(mark.right - mark.left < 12);
  CHECK(mark.x == Approx(0.5 * (corners.left + corners.right)).margin(1.5));
  CHECK(mark.y == Approx(0.5 * (corners.top + corners.bottom)).margin(1.5));
}

TEST_CASE("nothing is drawn but what is asked for", "[io][plot]") {
  Plot plot = sample();
  plot.series = {{.name = "flat", .points = {{64, 3}, {1024, 3}}}};
  const Pixels pixels = drawn(plot);
  const Pixels::Ink line = pixels.ink(blue, 0, legend);
  REQUIRE(line.count > 1000);
  CHECK(line.bottom - line.top < 12);
  const Pixels::Ink key = pixels.ink(blue, legend, pixels.height);
  REQUIRE(key.count > 30);
  CHECK(key.right - key.left < 40);
  CHECK(key.bottom - key.top < 12);
  CHECK(pixels.ink({255, 255, 255}, 0, pixels.height).count > 800 * 600 * 9 / 10);
}

TEST_CASE("a dashed line has less ink, and one without markers none at its points", "[io][plot]") {
  Plot plot = sample();
  plot.series = {{.name = "a", .points = {{64, 3}, {1024, 3}}, .marked = false}};
  const int whole = drawn(plot).ink(blue, 0, legend).count;
  plot.series[0].dashed = true;
  const int dashed = drawn(plot).ink(blue, 0, legend).count;
  CHECK(dashed < 0.75 * whole);
  CHECK(dashed > 0.4 * whole);
  plot.series[0] = {.name = "a", .points = {{128, 3}}, .marked = false};
  CHECK(drawn(plot).ink(blue, 0, legend).count == 0);
}

// Does every element end, in order?
bool well_formed(const std::string& text) {
  std::vector<std::string> open;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) {
      return false;
    }
    const std::string tag = text.substr(at + 1, end - at - 1);
    if (tag.starts_with('?') || tag.ends_with('/')) {
      continue;
    }
    if (!tag.starts_with('/')) {
      open.push_back(tag.substr(0, tag.find(' ')));
    } else if (open.empty() || open.back() != tag.substr(1)) {
      return false;
    } else {
      open.pop_back();
    }
  }
  return open.empty();
}

TEST_CASE("SVG has lines as paths and words as words", "[io][plot]") {
  const std::string svg = written(".svg", sample());
  CHECK(svg.starts_with("<?xml"));
  CHECK(well_formed(svg));
  for (const char* words : {"Edges &lt;by&gt; size", "n &amp; m", ">share<", "a &lt; b",
                            "glass &amp; mirrors", ">1024<", ">10<"}) {
    INFO(words);
    CHECK(svg.find(words) != std::string::npos);
  }
  CHECK(svg.find("rgb(0%,44.7%,69.8%)") != std::string::npos);
  CHECK(svg.find("rgb(83.5%,36.9%,0%)") != std::string::npos);
}

TEST_CASE("a plot has the same bytes whatever was drawn before", "[io][plot]") {
  const std::string extension = GENERATE(".svg", ".png");
  const std::string first = written(extension, sample());
  Plot other = sample();
  other.series[0].points[1].y = 7;
  CHECK((written(extension, other) != first));
  CHECK((written(extension, sample()) == first));
}

TEST_CASE("words that are not ASCII do no harm", "[io][plot]") {
  Plot plot = sample();
  plot.series[0].name = "caf\xc3\xa9 \xff|\x01.";
  CHECK(written(".svg", plot).find("caf\?\? \?|\?.<") != std::string::npos);
  CHECK(written(".png", plot).size() > 1000);
}

TEST_CASE("a plot that cannot be drawn is refused and leaves no file", "[io][plot]") {
  Plot plot = sample();
  std::string says;
  std::string extension = ".svg";
  SECTION("no series") {
    plot.series.clear();
    says = "there is no series";
  }
  SECTION("no points") {
    plot.series[1].points.clear();
    says = "series 'glass & mirrors' has no points";
  }
  SECTION("not a number") {
    plot.series[0].points[2].y = std::numeric_limits<double>::quiet_NaN();
    says = "(1024, nan) is not finite";
  }
  SECTION("infinite") {
    plot.series[0].points[0].x = std::numeric_limits<double>::infinity();
    says = "(inf, 0) is not finite";
  }
  SECTION("zero on a logarithmic axis") {
    plot.y.scale = AxisScale::decimal;
    says = "a logarithmic axis cannot show 0";
  }
  SECTION("another kind of file") {
    extension = ".pdf";
    says = ".svg or .png";
  }
  const fs::path path = temporary("bad" + extension);
  CHECK_THROWS_AS(write_plot(path, plot), std::invalid_argument);
  CHECK_THROWS_WITH(write_plot(path, plot), Catch::Contains(says));
  CHECK_FALSE(fs::exists(path));
}

}  // namespace
}  // namespace raycat
