#include "antialias/thin_points.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include <catch2/catch.hpp>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <rapidcheck.h>

#include "antialias/adaptive.hpp"
#include "antialias/pictures.hpp"

namespace raycat {
namespace {

// A picture of which it is said where something thin may be.
class Told : public Picture {
 public:
  Told(const std::function<bool(const glm::dvec2&)>& inside, std::vector<glm::dvec2> points)
      : Picture(two_colours(inside)), points_(std::move(points)) {}

  void thin(const std::function<void(const glm::dvec2&)>& visit) const override {
    std::ranges::for_each(points_, visit);
  }

 private:
  std::vector<glm::dvec2> points_;
};

TEST_CASE("points at which to look are known by pixel", "[antialias]") {
  const auto nowhere = [](const glm::dvec2&) { return false; };
  const Told some(nowhere,
                  {{2.5, 1.25}, {0.0, 0.0}, {2.75, 1.5}, {-0.1, 1.0}, {3.0, 1.0}, {1.0, 2.0}});
  const ThinPoints points(some, 3, 2, 16);
  CHECK(points.in(2, 1).size() == 2);
  CHECK(points.in(2, 1)[0] == glm::ivec2(40, 20));
  CHECK(points.in(2, 1)[1] == glm::ivec2(44, 24));
  CHECK(points.in(0, 0).size() == 1);
  CHECK(points.in(1, 1).empty());
  const Told one_place(nowhere, std::vector<glm::dvec2>(1000, glm::dvec2(0.5)));
  const ThinPoints many(one_place, 3, 2, 16);
  CHECK(many.in(0, 0).size() == 8);
}

// In each pixel a disc that covers none of its corners.
constexpr glm::dvec2 middle(0.45, 0.6);
constexpr double radius = 0.2;
bool in_disc(const glm::dvec2& point) { return glm::distance(glm::fract(point), middle) < radius; }

TEST_CASE("what all corners miss is found where it is said to be", "[antialias]") {
  const double area = std::numbers::pi * radius * radius;
  // One is said to be where nothing is.
  Told discs(in_disc, {middle, middle + glm::dvec2(2, 1), {3.9, 3.9}});
  const AntialiasedPicture is = antialias_adaptively(
      discs, {.width = 4, .height = 4, .threads = 1, .coverage = true, .progress = {}},
      {.error = 0.0005f});
  CHECK(is.colour[is.index(0, 0)].g == Approx(area).margin(0.004));
  CHECK(is.colour[is.index(2, 1)].g == Approx(area).margin(0.004));
  CHECK(is.colour[is.index(3, 3)].g == 0.0f);
  CHECK(is.colour[is.index(1, 0)].g == 0.0f);
  float share = 0.0f;
  for (const TreeShare& each : is.coverage[is.index(2, 1)]) {
    share += each.tree == TreeId{1} ? each.share : 0.0f;
  }
  CHECK(share == Approx(area).margin(0.004));
}

TEST_CASE("a wire of any width and direction is covered as much as it is",
          "[antialias][property]") {
  CHECK(rc::check("wires", [] {
    const double width = *rc::gen::inRange(20, 100) / 100.0;
    const double angle = *rc::gen::inRange(0, 180) * std::numbers::pi / 180.0;
    const glm::dvec2 along(std::cos(angle), std::sin(angle));
    const glm::dvec2 start =
        glm::dvec2(8.0) - 5.0 * along +
        glm::dvec2(*rc::gen::inRange(0, 100), *rc::gen::inRange(0, 100)) / 100.0;
    std::vector<glm::dvec2> points;
    for (double t = 0.125; t < 10.0; t += 0.25) {
      points.push_back(start + t * along);
    }
    Told wire(
        [=](const glm::dvec2& p) {
          const double t = glm::dot(p - start, along);
          const glm::dvec2 across(-along.y, along.x);
          return t > 0.0 && t < 10.0 && std::abs(glm::dot(p - start, across)) < 0.5 * width;
        },
        points);
    const AntialiasedPicture is = antialias_adaptively(
        wire, {.width = 17, .height = 17, .threads = 1, .progress = {}}, {.error = 0.003f});
    double sum = 0.0;
    for (const glm::vec4& pixel : is.colour) {
      sum += pixel.g;
    }
    RC_ASSERT(std::abs(sum / (10.0 * width) - 1.0) < 0.15);
  }));
}

TEST_CASE("what all corners miss is found within a budget, and no more is spent", "[antialias]") {
  std::vector<glm::dvec2> everywhere;
  for (int i = 0; i < 16 * 16; ++i) {
    everywhere.push_back(middle + glm::dvec2(i % 16, i / 16));
  }
  Told discs(in_disc, everywhere);
  for (const double budget : {1.2, 40.0}) {
    const AntialiasedPicture is =
        antialias_adaptively(discs, {.width = 16, .height = 16, .threads = 1, .progress = {}},
                             {.error = 0.0f, .budget = budget});
    CHECK(is.samples.colour + is.samples.category_only <=
          std::max<std::uint64_t>(17 * 17, static_cast<std::uint64_t>(budget * 256)));
    double sum = 0.0;
    for (const glm::vec4& pixel : is.colour) {
      sum += pixel.g;
    }
    const double area = 256 * std::numbers::pi * radius * radius;
    CHECK(sum < 1.05 * area);
    CHECK((budget < 2.0 || sum > 0.75 * area));
  }
}

TEST_CASE("looking where nothing is costs a ray", "[antialias]") {
  Told discs(in_disc, {{3.9, 3.9}, {1.1, 1.9}});
  const AntialiasedPicture is = antialias_adaptively(
      discs, {.width = 4, .height = 4, .threads = 1, .progress = {}}, {.error = 0.002f});
  CHECK(is.samples.colour + is.samples.category_only == 25 + 2);
}

}  // namespace
}  // namespace raycat
