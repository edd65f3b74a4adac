#include <cmath>

#include <catch2/catch.hpp>

#include "antialias/antialias.hpp"
#include "antialias/pictures.hpp"

namespace raycat {
namespace {

AntialiasSettings of(int width, int height, int threads = 1) {
  return {.width = width, .height = height, .threads = threads, .progress = {}};
}

// White left of x = 2.25.
Picture half() {
  return two_colours([](const glm::dvec2& p) { return p.x < 2.25; });
}

TEST_CASE("uniform samples are at the middles of a pixel's squares", "[antialias]") {
  Picture picture = half();
  const AntialiasedPicture is = antialias_uniformly(picture, of(4, 1), 4);
  CHECK(is.samples.colour == 64);
  CHECK(is.colour[1] == glm::vec4(1.0f));
  CHECK(is.colour[2] == glm::vec4(0.25f));
  CHECK(is.colour[3] == glm::vec4(0.0f));
}

TEST_CASE("pixels that are not selected are the mean of their corners", "[antialias]") {
  Picture picture([](const glm::dvec2& p) -> ColourSample {
    return {.colour = glm::vec4(glm::vec3(static_cast<float>(0.1 * p.x + 0.2 * p.y)), 1.0f)};
  });
  const AntialiasedPicture is = antialias_selected(picture, of(3, 2), by_colour(0.9f), 4);
  CHECK(is.samples.colour == 12);
  CHECK(is.refined == 0);
  CHECK(is.colour[is.index(1, 1)].r == Approx(0.1 * 1.5 + 0.2 * 1.5));
}

TEST_CASE("selected pixels share the samples of their borders", "[antialias]") {
  Picture picture = half();
  // Both corners' columns x = 2 and 3 differ: the column of pixels 2. Of 5 x 5 points in each of 3
  // pixels, 4 and the borders between them are shared, and 8 corners were there.
  const AntialiasedPicture is = antialias_selected(picture, of(4, 3), by_colour(0.1f), 4);
  CHECK(is.refined == 3);
  CHECK(is.samples.colour == 5 * 4 + 5 * 13 - 8);
  // Columns at 0, 1/4, ... 1 with weights 1/8, 1/4, 1/4, 1/4, 1/8: only the first is white.
  CHECK(is.colour[2].r == Approx(0.125));
}

TEST_CASE("categories select where colours do not", "[antialias]") {
  Picture picture =
      two_colours([](const glm::dvec2& p) { return p.x < 2.25; }, glm::vec4(0.5f), glm::vec4(0.5f));
  CHECK(antialias_selected(picture, of(4, 1), by_category(), 2).refined == 1);
  CHECK(antialias_selected(picture, of(4, 1), by_colour(0.0f), 2).refined == 0);
}

TEST_CASE("Whitted's method subdivides what differs until it is small", "[antialias]") {
  Picture picture = half();
  const AntialiasedPicture is =
      antialias_recursively(picture, of(4, 1), subdivide_by_colour(0.1f, false), 3);
  CHECK(is.refined == 1);
  // 1/4 exactly on a border of squares: white up to it, then half of a square of 1/8.
  CHECK(is.colour[2].r == Approx(0.1875));
  const auto rays = [](float threshold, bool by_area) {
    Picture again = half();
    return antialias_recursively(again, of(4, 1), subdivide_by_colour(threshold, by_area), 3)
        .samples.colour;
  };
  CHECK(rays(0.1f, true) < rays(0.1f, false));
  CHECK(rays(1.1f, false) == 10);
}

TEST_CASE("all methods are the same whatever the number of threads", "[antialias]") {
  const auto wavy = [] {
    return two_colours([](const glm::dvec2& p) { return std::sin(p.x) + std::cos(1.3 * p.y) > 0; });
  };
  const auto both = [&](const auto& method) {
    Picture one = wavy();
    Picture many = wavy();
    const AntialiasedPicture a = method(one, of(31, 23, 1));
    const AntialiasedPicture b = method(many, of(31, 23, 4));
    CHECK(a.colour == b.colour);
    CHECK(a.samples.colour == b.samples.colour);
  };
  both([](Sampler& s, const AntialiasSettings& at) { return antialias_uniformly(s, at, 3); });
  both([](Sampler& s, const AntialiasSettings& at) {
    return antialias_selected(s, at, by_colour(0.1f), 3);
  });
  both([](Sampler& s, const AntialiasSettings& at) {
    return antialias_recursively(s, at, subdivide_by_category(), 4);
  });
}

}  // namespace
}  // namespace raycat
