#include "io/openscad/touching_boxes.hpp"

#include <cstdint>
#include <vector>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

namespace raycat {
namespace {

// Spreads the least number of each group until nothing changes.
std::vector<std::uint32_t> by_brute_force(const std::vector<Bounds>& boxes) {
  std::vector<std::uint32_t> group(boxes.size());
  std::uint32_t next = 0;
  std::vector<bool> seen(boxes.size(), false);
  for (std::size_t first = 0; first < boxes.size(); ++first) {
    if (seen[first]) {
      continue;
    }
    std::vector<std::size_t> open{first};
    seen[first] = true;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      group[at] = next;
      for (std::size_t other = 0; other < boxes.size(); ++other) {
        if (!seen[other] && !intersection(boxes[at], boxes[other]).empty()) {
          seen[other] = true;
          open.push_back(other);
        }
      }
    }
    ++next;
  }
  return group;
}

TEST_CASE("boxes are grouped as by comparing each with each", "[io]") {
  CHECK(group_touching({}).empty());
  CHECK(rc::check("groups", [] {
    std::vector<Bounds> boxes(*rc::gen::inRange<std::size_t>(1, 40));
    for (Bounds& box : boxes) {
      for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = *rc::gen::inRange(0, 12);
        box.max[axis] = box.min[axis] + *rc::gen::inRange(0, 5);
      }
    }
    RC_ASSERT(group_touching(boxes) == by_brute_force(boxes));
  }));
}

TEST_CASE("many boxes in one heap are grouped as fast as many apart", "[io]") {
  const std::vector<Bounds> boxes(300'000, Bounds{.min = glm::dvec3(0.0), .max = glm::dvec3(1.0)});
  CHECK(group_touching(boxes).back() == 0);
}

}  // namespace
}  // namespace raycat
