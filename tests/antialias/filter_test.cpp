#include "antialias/filter.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "antialias/adaptive.hpp"
#include "antialias/pictures.hpp"

namespace raycat {
namespace {

constexpr Filter all_filters[] = {Filter::box, Filter::tent, Filter::gaussian, Filter::mitchell};

AntialiasSettings of(int width, int height, Filter filter, int threads = 1) {
  return {.width = width, .height = height, .threads = threads, .filter = filter, .progress = {}};
}

// The part of the filter left of `x` pixels from its middle.
double left_of(Filter filter, double x) {
  constexpr int steps = 40000;
  double sum = 0.0;
  double left = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double at = -2.0 + (i + 0.5) * 4.0 / steps;
    sum += weight(filter, at);
    left += at < x ? weight(filter, at) : 0.0;
  }
  return left / sum;
}

TEST_CASE("tent and mitchell have the values that they are known for", "[antialias][filter]") {
  CHECK(weight(Filter::tent, 0.25) == 0.75);
  CHECK(weight(Filter::tent, -1.5) == 0.0);
  // Mitchell and Netravali: 8/9 in the middle, 1/18 at one pixel, if the integral is 1; below zero
  // further out.
  CHECK(weight(Filter::mitchell, 0.0) / 6.0 == Approx(8.0 / 9.0));
  CHECK(weight(Filter::mitchell, -1.0) / 6.0 == Approx(1.0 / 18.0));
  CHECK(weight(Filter::mitchell, 1.5) < 0.0);
  for (const Filter filter : all_filters) {
    CHECK(weight(filter, reach(filter) + 0.51) == 0.0);
  }
  for (double x = 0.0; x < 1.0; x += 0.1) {
    double sum = 0.0;
    for (int i = -2; i <= 2; ++i) {
      sum += weight(Filter::mitchell, x + i);
    }
    CHECK(sum / 6.0 == Approx(1.0));
  }
}

TEST_CASE("a straight edge is filtered as its integral says", "[antialias][filter]") {
  for (const Filter filter : all_filters) {
    for (const double edge : {6.0, 6.2, 6.55, 6.9}) {
      Picture picture = two_colours([&](const glm::dvec2& p) { return p.x < edge; });
      const AntialiasedPicture uniform = antialias_uniformly(picture, of(12, 5, filter), 64);
      const AntialiasedPicture adaptive =
          antialias_adaptively(picture, of(12, 5, filter), {.error = 0.001f});
      for (int x = 2; x < 10; ++x) {
        const double expected = left_of(filter, edge - (x + 0.5));
        CAPTURE(static_cast<int>(filter), edge, x);
        for (int y = 0; y < 5; ++y) {
          CHECK(uniform.colour[uniform.index(x, y)].r == Approx(expected).margin(0.012));
          CHECK(adaptive.colour[adaptive.index(x, y)].r == Approx(expected).margin(1.0 / 250));
        }
      }
    }
  }
}

TEST_CASE("filters give the same of slanted edges and shades by both methods",
          "[antialias][filter]") {
  Picture picture([](const glm::dvec2& p) -> ColourSample {
    const bool is = 0.6 * p.x + 0.8 * p.y < 9.3;
    const double shade = 0.4 + 0.02 * p.x - 0.01 * p.y + (is ? 0.3 : 0.0);
    return {.colour = glm::vec4(glm::vec3(static_cast<float>(shade)), 1.0f),
            .tree = TreeId{is ? 1u : 0u}};
  });
  for (const Filter filter : all_filters) {
    const AntialiasedPicture uniform = antialias_uniformly(picture, of(14, 12, filter), 32);
    const AntialiasedPicture adaptive =
        antialias_adaptively(picture, of(14, 12, filter), {.error = 0.001f});
    for (std::size_t i = 0; i < uniform.colour.size(); ++i) {
      CAPTURE(static_cast<int>(filter), i);
      CHECK(adaptive.colour[i].g == Approx(uniform.colour[i].g).margin(0.003));
    }
  }
}

TEST_CASE("what is the same everywhere stays so, up to the picture's sides",
          "[antialias][filter]") {
  Picture picture([](const glm::dvec2&) -> ColourSample { return {.colour = glm::vec4(0.5f)}; });
  for (const Filter filter : all_filters) {
    for (const glm::vec4& pixel : antialias_uniformly(picture, of(3, 2, filter), 3).colour) {
      CHECK(pixel.r == Approx(0.5f));
      CHECK(pixel.a == Approx(0.5f));
    }
    for (const glm::vec4& pixel : antialias_adaptively(picture, of(3, 2, filter), {}).colour) {
      CHECK(pixel.r == Approx(0.5f));
    }
  }
}

TEST_CASE("filtered pictures do not depend on threads", "[antialias][filter]") {
  const auto antialiased = [](int threads) {
    Picture picture =
        two_colours([](const glm::dvec2& p) { return std::sin(p.x) + std::cos(1.3 * p.y) > 0; });
    return std::pair(
        antialias_uniformly(picture, of(30, 21, Filter::mitchell, threads), 3).colour,
        antialias_adaptively(picture, of(30, 21, Filter::mitchell, threads), {}).colour);
  };
  CHECK((antialiased(3) == antialiased(1)));
}

}  // namespace
}  // namespace raycat
