#include "csg/leaf_bvh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/common.hpp>
#include <rapidcheck.h>

#include "tests/geometry/lines.hpp"

namespace raycat {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double longest_half(const std::vector<Bounds>& boxes) {
  Bounds all;
  for (const Bounds& box : boxes) {
    all.include(box);
  }
  const glm::dvec3 half = all.half_size();
  return std::max({half.x, half.y, half.z});
}

// Where the line is in the box, in extended precision.
Interval inside(const Ray& ray, const Bounds& box, double margin) {
  long double begin = -infinity;
  long double end = infinity;
  for (int axis = 0; axis < 3; ++axis) {
    const long double low = static_cast<long double>(box.min[axis]) - margin - ray.origin[axis];
    const long double high = static_cast<long double>(box.max[axis]) + margin - ray.origin[axis];
    if (ray.direction[axis] == 0.0) {
      if (low > 0 || high < 0) {
        return {.begin = 1.0, .end = 0.0};
      }
      continue;
    }
    const long double a = low / ray.direction[axis];
    const long double b = high / ray.direction[axis];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  return {.begin = static_cast<double>(begin), .end = static_cast<double>(end)};
}

// Boxes of all sizes about one place, some of them flat, some of them the same.
std::vector<Bounds> any_boxes(Dice& dice) {
  const double size = dice.scale();
  const glm::dvec3 at = dice.in_box(dice.below(2) == 0 ? size : 1000.0 * size);
  std::vector<Bounds> boxes;
  for (int count = dice.below(120); count >= 0; --count) {
    if (!boxes.empty() && dice.below(8) == 0) {
      boxes.push_back(boxes[static_cast<std::size_t>(dice.below(static_cast<int>(boxes.size())))]);
      continue;
    }
    const glm::dvec3 low = at + dice.in_box(size);
    glm::dvec3 extent = glm::abs(dice.in_box(size * std::pow(10.0, dice.between(-4.0, 0.0))));
    if (dice.below(6) == 0) {
      extent[dice.below(3)] = 0.0;
    }
    boxes.push_back({.min = low, .max = low + extent});
  }
  return boxes;
}

Ray any_line(Dice& dice, const std::vector<Bounds>& boxes) {
  // Through a box's corner, edge or face as often as not, and often along an axis.
  const Bounds& box = boxes[static_cast<std::size_t>(dice.below(static_cast<int>(boxes.size())))];
  glm::dvec3 through = box.center();
  for (int axis = 0; axis < 3; ++axis) {
    const int where = dice.below(4);
    through[axis] = where == 0 ? box.min[axis] : where == 1 ? box.max[axis] : through[axis];
  }
  glm::dvec3 direction = dice.direction();
  if (dice.below(3) == 0) {
    direction = glm::dvec3(0.0);
    direction[dice.below(3)] = dice.below(2) == 0 ? 1.0 : -1.0;
  } else if (dice.below(4) == 0) {
    direction[dice.below(3)] *= 1e-25;
  }
  const double away = longest_half(boxes) * dice.between(-20.0, 20.0);
  return {.origin = through - away * direction, .direction = direction * dice.scale()};
}

TEST_CASE("the index finds the boxes that a line meets, and hardly any other", "[csg][index]") {
  CHECK(rc::check("boxes", [] {
    Dice dice;
    const std::vector<Bounds> boxes = any_boxes(dice);
    const LeafBvh index(boxes);
    const double size = longest_half(boxes);
    for (int i = 0; i < 50; ++i) {
      const Ray ray = any_line(dice, boxes);
      std::vector<int> times(boxes.size());
      index.visit(ray, [&](std::uint32_t box) { ++times[box]; });
      for (std::size_t k = 0; k < boxes.size(); ++k) {
        RC_ASSERT(times[k] <= 1);
        // A box grazed within what double precision knows of the line is met or not.
        const double unsure =
            1e-14 * (glm::length(ray.origin - boxes[k].center()) + glm::length(boxes[k].center()));
        if (!inside(ray, boxes[k], -unsure).empty()) {
          RC_ASSERT(times[k] == 1);
        }
        if (times[k] == 1) {
          RC_ASSERT(!inside(ray, boxes[k], 2e-6 * size + unsure).empty());
        }
      }
    }
  }));
}

TEST_CASE("a search finds the boxes of a window in order, no sooner than asked", "[csg][index]") {
  CHECK(rc::check("search", [] {
    Dice dice;
    std::vector<Bounds> boxes = any_boxes(dice);
    const double size = longest_half(boxes);
    boxes.push_back({.min = glm::dvec3(-infinity), .max{infinity, 0.0, infinity}});
    boxes.emplace_back();  // empty
    const LeafBvh index(boxes);
    LeafBvh::Search search;
    for (int i = 0; i < 30; ++i) {
      boxes.resize(boxes.size() - 2);
      const Ray ray = any_line(dice, boxes);
      boxes.resize(boxes.size() + 2);
      const double unit = size / glm::length(ray.direction);
      const Interval window{.begin = dice.between(-20, 20) * unit, .end = infinity};
      search.start(index, ray, window);
      RC_ASSERT(search.next(-infinity) == std::uint32_t(boxes.size() - 2));
      std::vector<bool> found(boxes.size());
      double limit = window.begin;
      for (int step = 0; step < 40; ++step) {
        limit = step == 39 ? infinity : limit + dice.between(0.0, 2.0) * unit;
        while (const auto box = search.next(limit)) {
          RC_ASSERT(!found[*box]);
          found[*box] = true;
          const Interval in = inside(ray, boxes[*box], 2e-6 * size);
          RC_ASSERT(in.begin <= limit + 1e-6 * unit);
        }
        for (std::size_t k = 0; k + 2 < boxes.size(); ++k) {
          const Interval in = inside(ray, boxes[k], -1e-11 * size);
          if (!in.empty() && in.end >= window.begin && in.begin <= limit) {
            RC_ASSERT(found[k]);
          }
        }
      }
    }
  }));
}

TEST_CASE("boxes of very unlike sizes are found", "[csg][index]") {
  // Each ten times as large as the one in it, so that a split takes off one at a time.
  std::vector<Bounds> boxes;
  for (int k = -150; k <= 150; ++k) {
    const double size = std::pow(10.0, k);
    boxes.push_back({.min = glm::dvec3(0.5 * size), .max = glm::dvec3(size)});
  }
  const LeafBvh index(boxes);
  std::size_t met = 0;
  index.visit({.origin = glm::dvec3(-1.0), .direction = glm::dvec3(1.0)},
              [&](std::uint32_t) { ++met; });
  CHECK(met == boxes.size());
  met = 0;
  index.visit({.origin = {0.75e150, 0.75e150, -1.0}, .direction = {0, 0, 1}},
              [&](std::uint32_t) { ++met; });
  CHECK(met == 1);
}

TEST_CASE("an index of no boxes meets nothing", "[csg][index]") {
  const LeafBvh index({});
  index.visit({}, [](std::uint32_t) { FAIL(); });
  LeafBvh::Search search;
  search.start(index, {}, {});
  CHECK_FALSE(search.next(infinity));
}

}  // namespace
}  // namespace raycat
