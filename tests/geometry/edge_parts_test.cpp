#include "geometry/edge_parts.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <utility>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <rapidcheck.h>

#include "geometry/edge_uses.hpp"
#include "geometry/exactly_between.hpp"

namespace raycat {
namespace {

std::vector<std::uint32_t> all_half_edges(const std::vector<glm::uvec3>& triangles) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t half = 0; half < 3 * triangles.size(); ++half) {
    if (half_edge_start(triangles, half) != half_edge_end(triangles, half)) {
      all.push_back(half);
    }
  }
  return all;
}

// The vertices of a half-edge in order, its ends too.
std::vector<std::uint32_t> chain(const std::vector<EdgePart>& parts, std::uint32_t half) {
  std::map<double, const EdgePart*> by_start;
  for (const EdgePart& part : parts) {
    if (part.half == half) {
      by_start[part.from] = &part;
    }
  }
  std::vector<std::uint32_t> out;
  for (const auto& [from, part] : by_start) {
    if (out.empty()) {
      out.push_back(part->from_vertex());
    }
    CHECK(out.back() == part->from_vertex());
    out.push_back(part->upwards ? part->high : part->low);
  }
  return out;
}

TEST_CASE("an edge is cut at the ends of others that lie on it, in their order",
          "[geometry][edge_parts]") {
  const std::vector<glm::dvec3> points{{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {2.0, 3.0, 0.0},
                                       {3.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {2.0, -1.0, 0.0},
                                       {9.0, 0.0, 0.0}, {2.0, 1e-3, 0.0}};
  const std::vector<glm::uvec3> triangles{{0, 1, 2}, {3, 4, 5}, {6, 7, 5}};
  const auto parts = edge_parts(points, triangles, all_half_edges(triangles), 0.0);
  CHECK(chain(parts, 0) == std::vector<std::uint32_t>{0, 4, 3, 1});
  CHECK(chain(parts, 1) == std::vector<std::uint32_t>{1, 2});
  CHECK(chain(parts, 3) == std::vector<std::uint32_t>{3, 4});
  const auto loose = edge_parts(points, triangles, all_half_edges(triangles), 0.01);
  CHECK(chain(loose, 0) == std::vector<std::uint32_t>{0, 4, 7, 3, 1});
  CHECK(chain(loose, 3) == std::vector<std::uint32_t>{3, 7, 4});
}

TEST_CASE("edges that overlap are cut at each other's ends", "[geometry][edge_parts]") {
  const std::vector<glm::dvec3> points{{0.0, 0.0, 0.0}, {2.0, 2.0, 2.0}, {0.0, 1.0, 0.0},
                                       {1.0, 1.0, 1.0}, {3.0, 3.0, 3.0}, {0.0, 0.0, 1.0}};
  const std::vector<glm::uvec3> triangles{{0, 1, 2}, {4, 3, 5}};
  const std::vector<std::uint32_t> half_edges{0, 3};
  const auto parts = edge_parts(points, triangles, half_edges, 0.0);
  CHECK(chain(parts, 0) == std::vector<std::uint32_t>{0, 3, 1});
  CHECK(chain(parts, 3) == std::vector<std::uint32_t>{4, 1, 3});
  int shared = 0;
  for_each_place(parts, [&](std::span<const EdgePart> of_place) {
    if (of_place.size() == 2) {
      ++shared;
      CHECK(of_place[0].low == 1);
      CHECK(of_place[0].high == 3);
      CHECK(of_place[0].upwards != of_place[1].upwards);
      CHECK(of_place[0].from == 0.5);
      CHECK(of_place[0].to == 1.0);
    }
  });
  CHECK(shared == 1);
}

TEST_CASE("the vertices on an edge are those of a search through all", "[geometry][edge_parts]") {
  CHECK(rc::check("on a lattice", [] {
    const auto corners = *rc::gen::container<std::vector<std::uint32_t>>(
        3 * *rc::gen::inRange<std::size_t>(1, 30), rc::gen::inRange(0U, 125U));
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 125; ++i) {
      points.emplace_back(0.1 * (i % 5), 7e3 + i / 5 % 5, 0.3 * (i / 25));
    }
    std::vector<glm::uvec3> triangles;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      triangles.emplace_back(corners[i], corners[i + 1], corners[i + 2]);
    }
    const auto half_edges = all_half_edges(triangles);
    const std::set<std::uint32_t> ends(corners.begin(), corners.end());
    const bool exact = *rc::gen::arbitrary<bool>();
    const double tolerance = exact ? 0.0 : 1e-6;
    const auto parts = edge_parts(points, triangles, half_edges, tolerance);
    std::map<std::uint32_t, std::size_t> inside;
    for (const std::uint32_t half : half_edges) {
      const glm::dvec3& a = points[half_edge_start(triangles, half)];
      const glm::dvec3& b = points[half_edge_end(triangles, half)];
      for (const std::uint32_t end : ends) {
        const glm::dvec3& p = points[end];
        const double detour = glm::distance(a, p) + glm::distance(p, b) - glm::distance(a, b);
        inside[half] += exact                               ? exactly_between(p, a, b)
                        : p != a && p != b && detour < 1e-9 ? 1U
                                                            : 0U;
      }
    }
    if (parts.empty()) {
      RC_ASSERT(std::ranges::all_of(inside, [](const auto& of) { return of.second == 0; }));
      return;
    }
    for (const EdgePart& part : parts) {
      RC_ASSERT(part.low < part.high);
      --inside[part.half];
    }
    for (const auto& [half, left] : inside) {
      RC_ASSERT(left + 1 == 0U);  // one part more than vertices inside
    }
  }));
}

TEST_CASE("parts are the same on any number of threads", "[geometry][edge_parts]") {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> at(0, 60);
  std::vector<glm::dvec3> points;
  std::vector<glm::uvec3> triangles;
  for (std::uint32_t i = 0; i < 12000; ++i) {
    const double y = at(random);
    points.insert(points.end(), {{at(random), y, 0.0}, {at(random), y, 0.0}, {0.0, y, 1.0 + i}});
    triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
  }
  std::vector<std::uint32_t> half_edges;
  for (std::uint32_t i = 0; i < 12000; ++i) {
    half_edges.insert(half_edges.end(), {3 * i + 1, 3 * i + 2});
  }
  const auto key = [](const EdgePart& part) {
    return std::tuple(part.low, part.high, part.half, part.from, part.to);
  };
  const auto one = edge_parts(points, triangles, half_edges, 1e-6, 1);
  const auto many = edge_parts(points, triangles, half_edges, 1e-6, 4);
  CHECK(one.size() >= half_edges.size());
  CHECK(std::ranges::equal(one, many, {}, key, key));
}

TEST_CASE("where everything lies on everything, nothing is cut", "[geometry][edge_parts]") {
  std::vector<glm::dvec3> points{{0.0, 1.0, 0.0}};
  std::vector<glm::uvec3> triangles;
  std::vector<std::uint32_t> half_edges;
  for (std::uint32_t i = 0; i < 200; ++i) {
    points.emplace_back(-1.0 - i, 0.0, 0.0);
    points.emplace_back(1.0 + i, 0.0, 0.0);
    triangles.emplace_back(2 * i + 1, 2 * i + 2, 0);
    half_edges.push_back(3 * i);
  }
  CHECK(edge_parts(points, triangles, half_edges, 0.0).empty());
  half_edges.resize(30);
  CHECK(edge_parts(points, triangles, half_edges, 0.0).size() == 30 + 30 * 29);
}

TEST_CASE("the tolerance knows floats from doubles", "[geometry][edge_parts]") {
  const double far = 5.4e6;
  CHECK(edge_tolerance(std::vector<glm::dvec3>{{far, 0.0, 0.0}, {far + 2.0, 0.0, 0.0}}) ==
        Approx(far * 0x1p-22));
  CHECK(edge_tolerance(std::vector<glm::dvec3>{{far, 0.1, 0.0}, {far + 2.0, 0.1, 0.0}}) ==
        Approx(1e-6));
}

}  // namespace
}  // namespace raycat
