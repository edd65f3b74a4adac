#include "antialias/sample_lattice.hpp"

#include <random>
#include <set>
#include <utility>

#include <catch2/catch.hpp>

#include "antialias/pictures.hpp"

namespace raycat {
namespace {

TEST_CASE("each point of the lattice is traced once and found again", "[antialias]") {
  Picture picture([](const glm::dvec2& p) -> ColourSample {
    return {.colour = {static_cast<float>(p.x), static_cast<float>(p.y), 0.0f, 1.0f}};
  });
  SampleLattice lattice(picture, 3, 2, 8, 1);
  lattice.trace_corners(1);
  CHECK(lattice.counts().colour == 12);
  std::mt19937 random(1);
  std::set<std::pair<int, int>> there;
  for (int i = 0; i < 2000; ++i) {
    const glm::ivec2 point(static_cast<int>(random() % 25), static_cast<int>(random() % 17));
    const bool corner = point.x % 8 == 0 && point.y % 8 == 0;
    const bool known = !there.insert({point.x, point.y}).second || corner;
    CHECK((lattice.find(point) != nullptr) == known);
    bool fresh = false;
    const ColourSample& sample = lattice.at(point, 0, &fresh);
    CHECK(fresh == !known);
    CHECK(sample.colour.x == static_cast<float>(point.x) / 8.0f);
    CHECK(sample.colour.y == static_cast<float>(point.y) / 8.0f);
    CHECK(lattice.find(point) == &sample);
  }
  CHECK(lattice.counts().colour > 300);
  CHECK(lattice.find({-1, 3}) == nullptr);
  CHECK(lattice.find({3, 17}) == nullptr);
}

TEST_CASE("samples on a side are found in order, on borders and within pixels", "[antialias]") {
  Picture picture([](const glm::dvec2&) -> ColourSample { return {}; });
  SampleLattice lattice(picture, 2, 2, 8, 1);
  lattice.trace_corners(1);
  std::vector<SampleLattice::OnSide> met;
  const auto places = [&](const glm::ivec2& start, const glm::ivec2& end) {
    lattice.between(start, end, met);
    std::vector<int> all;
    for (const auto& each : met) {
      all.push_back(each.from_start);
    }
    return all;
  };
  for (const int line : {0, 4, 8}) {
    CHECK(places({line, 0}, {line, 8}).empty());
    for (const int at : {6, 1, 3}) {
      lattice.at({line, at}, 0);
      lattice.at({at, line}, 0);
    }
    CHECK(places({line, 0}, {line, 8}) == std::vector{1, 3, 6});
    CHECK(places({0, line}, {8, line}) == std::vector{1, 3, 6});
    CHECK(places({line, 2}, {line, 6}) == std::vector{1});
    CHECK(places({2, line}, {6, line}) == std::vector{1});
    CHECK(places({line, 1}, {line, 3}).empty());
  }
}

}  // namespace
}  // namespace raycat
