#include <algorithm>
#include <cmath>
#include <tuple>

#include <catch2/catch.hpp>

#include "antialias/adaptive.hpp"
#include "antialias/pictures.hpp"

namespace raycat {
namespace {

constexpr int width = 70;
constexpr int height = 50;

// Rings of several colours, some of which hardly differ, over a shade.
Picture rings() {
  return Picture([](const glm::dvec2& p) -> ColourSample {
    const double from_middle = std::hypot(p.x - 31.3, p.y - 24.1);
    const auto ring = static_cast<std::uint32_t>(from_middle / 6.4);
    const double shade = 0.1 * (ring % 3) + 0.4 * (ring % 2) + 0.003 * p.x;
    return {.colour = glm::vec4(glm::vec3(static_cast<float>(shade)), 1.0f), .tree = TreeId{ring}};
  });
}

AntialiasedPicture antialiased(const AdaptiveSettings& adaptive, int threads = 1) {
  Picture picture = rings();
  return antialias_adaptively(
      picture, {.width = width, .height = height, .threads = threads, .progress = {}}, adaptive);
}

double error_of(const AntialiasedPicture& is) {
  Picture picture = rings();
  static const AntialiasedPicture reference =
      antialias_uniformly(picture, {.width = width, .height = height, .progress = {}}, 32);
  double sum = 0.0;
  for (std::size_t i = 0; i < is.colour.size(); ++i) {
    sum += std::pow(static_cast<double>(is.colour[i].r - reference.colour[i].r), 2.0);
  }
  return std::sqrt(sum / static_cast<double>(is.colour.size()));
}

TEST_CASE("a budget is spent, but not exceeded", "[antialias][budget]") {
  double before = 1.0;
  for (const double budget : {1.3, 1.6, 2.0, 2.5}) {
    const AntialiasedPicture is = antialiased({.budget = budget});
    const auto rays = static_cast<double>(is.samples.colour + is.samples.category_only);
    CAPTURE(budget, rays);
    CHECK(rays <= budget * width * height);
    CHECK(rays > budget * width * height - 700.0);
    const double error = error_of(is);
    CHECK(error < before);
    before = error;
  }
}

TEST_CASE("a budget below the corners leaves these alone", "[antialias][budget]") {
  const AntialiasedPicture is = antialiased({.budget = 1.0});
  CHECK(is.samples.colour == (width + 1) * (height + 1));
  CHECK(is.refined == 0);
}

TEST_CASE("a budget that is more than can be used ends", "[antialias][budget]") {
  const AntialiasedPicture is = antialiased({.budget = 1000.0});
  CHECK(is.samples.colour < 300u * width * height);
  CHECK(error_of(is) < 0.002);
}

TEST_CASE("a budget buys about what an error that costs as much does", "[antialias][budget]") {
  for (const float error : {0.02f, 0.01f, 0.004f}) {
    const AntialiasedPicture told = antialiased({.error = error});
    const auto rays = static_cast<double>(told.samples.colour + told.samples.category_only);
    const AntialiasedPicture bought = antialiased({.budget = (rays + 320.0) / (width * height)});
    CAPTURE(error);
    CHECK(error_of(bought) < 1.15 * error_of(told));
  }
}

TEST_CASE("what a budget buys does not depend on threads", "[antialias][budget]") {
  const AntialiasedPicture one = antialiased({.budget = 1.7});
  const AntialiasedPicture three = antialiased({.budget = 1.7}, 3);
  CHECK((one.colour == three.colour));
  CHECK(one.samples.colour == three.samples.colour);
}

}  // namespace
}  // namespace raycat
