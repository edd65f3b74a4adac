#include "edges/refine.hpp"

#include <functional>
#include <set>
#include <utility>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

namespace raycat {
namespace {

// What the whole plane looks like: the category of each point.
using Plane = std::function<std::uint32_t(double x, double y)>;

CategoryImage sampled(int width, int height, const Plane& plane) {
  CategoryImage image{.width = width, .height = height};
  for (int y = 0; y <= height; ++y) {
    for (int x = 0; x <= width; ++x) {
      image.samples.push_back(CategoryId{plane(x, y)});
    }
  }
  return image;
}

std::uint32_t half_plane(double x, double y) { return 3.0 * x + 7.0 * y < 31.4 ? 0 : 1; }

std::uint32_t disc(double x, double y) {
  return (x - 4.3) * (x - 4.3) + (y - 3.6) * (y - 3.6) < 7.7 ? 1 : 0;
}

// Three categories, of the disc within the half-planes.
std::uint32_t both(double x, double y) { return disc(x, y) != 0 ? 2 : half_plane(x, y); }

// Noise, so that edges are everywhere and follow no rule.
std::uint32_t noise(double x, double y) {
  const std::array words{static_cast<std::uint32_t>(64 * x), static_cast<std::uint32_t>(64 * y)};
  return hash_words(words) % 5 == 0 ? 1 : 0;
}

// What was asked of a plane.
struct Asked {
  std::vector<std::vector<glm::dvec2>> calls;

  CategorySampler of(const Plane& plane) {
    return [this, plane](std::span<const glm::dvec2> points) {
      calls.emplace_back(points.begin(), points.end());
      std::vector<CategoryId> ids;
      for (const glm::dvec2& point : points) {
        ids.push_back(CategoryId{plane(point.x, point.y)});
      }
      return ids;
    };
  }
};

bool corners_differ(const Plane& plane, int x, int y, double side) {
  const std::uint32_t here = plane(x * side, y * side);
  return here != plane((x + 1) * side, y * side) || here != plane(x * side, (y + 1) * side) ||
         here != plane((x + 1) * side, (y + 1) * side);
}

// The map by its definition, over the whole lattice of each level in turn.
EdgeMap expected_map(const Plane& plane, int width, int height, int levels) {
  EdgeMap map{.width = width, .height = height, .pixels = {}};
  map.pixels.assign(static_cast<std::size_t>(width * height), 1);
  for (int n = 0; n <= levels; ++n) {
    EdgeMap finer{.width = width << n, .height = height << n, .pixels = {}};
    const int shift = n == 0 ? 0 : 1;
    for (int y = 0; y < finer.height; ++y) {
      for (int x = 0; x < finer.width; ++x) {
        const bool edge =
            map.at(x >> shift, y >> shift) && corners_differ(plane, x, y, 1.0 / (1 << n));
        finer.pixels.push_back(edge ? 1 : 0);
      }
    }
    map = std::move(finer);
  }
  return map;
}

TEST_CASE("no level of subpixels is the map of pixels", "[edges][refine]") {
  const CategoryImage image = sampled(9, 8, both);
  Asked asked;
  const RefinedEdges refined = refine_edges(image, 0, asked.of(both));
  CHECK(refined.map.pixels == detect_edges(image).pixels);
  CHECK(refined.map.width == 9);
  CHECK(refined.map.height == 8);
  CHECK(refined.sampled == 0);
  CHECK(asked.calls.empty());
}

TEST_CASE("one edge pixel is broken into its four subpixels", "[edges][refine]") {
  // 0 | 1 : the edge is at x = 0.6, so of the subpixels the right two hold it.
  const Plane plane = [](double x, double) { return x < 0.6 ? 0u : 1u; };
  Asked asked;
  const RefinedEdges refined = refine_edges(sampled(1, 1, plane), 1, asked.of(plane));
  CHECK(refined.map.pixels == std::vector<std::uint8_t>{0, 1,  //
                                                        0, 1});
  REQUIRE(asked.calls.size() == 1);
  CHECK(asked.calls[0] ==
        std::vector<glm::dvec2>{{0.5, 0.0}, {0.0, 0.5}, {0.5, 0.5}, {1.0, 0.5}, {0.5, 1.0}});

  // Of the right two, which share the sides' middle, each new point is asked once: nine of them.
  const RefinedEdges twice = refine_edges(sampled(1, 1, plane), 2, asked.of(plane));
  CHECK(twice.map.pixels == std::vector<std::uint8_t>{0, 0, 1, 0,  //
                                                      0, 0, 1, 0,  //
                                                      0, 0, 1, 0,  //
                                                      0, 0, 1, 0});
  CHECK(twice.sampled == 5 + 9);
}

TEST_CASE("a feature that no sample of its level meets is not found", "[edges][refine]") {
  const Plane dot = [](double x, double y) { return x == 0.5 && y == 0.5 ? 1u : 0u; };
  Asked asked;
  const RefinedEdges refined = refine_edges(sampled(3, 2, dot), 3, asked.of(dot));
  CHECK(refined.map.count() == 0);
  CHECK(refined.map.width == 24);
  CHECK(refined.map.height == 16);
  CHECK(asked.calls.empty());
}

TEST_CASE("subpixels are marked exactly where corners differ within marked squares",
          "[edges][refine]") {
  const Plane plane = GENERATE(Plane(half_plane), Plane(disc), Plane(both), Plane(noise));
  const int levels = GENERATE(1, 2, 3, 4, 6);
  Asked asked;
  const RefinedEdges refined = refine_edges(sampled(9, 8, plane), levels, asked.of(plane));
  const EdgeMap expected = expected_map(plane, 9, 8, levels);
  CHECK(refined.map.width == expected.width);
  CHECK(refined.map.height == expected.height);
  CHECK(refined.map.pixels == expected.pixels);
  CHECK(refined.map.count() > 0);
}

TEST_CASE("each point is asked once, and only if a marked square needs it", "[edges][refine]") {
  const Plane plane = GENERATE(Plane(half_plane), Plane(both), Plane(noise));
  Asked asked;
  const RefinedEdges refined = refine_edges(sampled(9, 8, plane), 4, asked.of(plane));
  REQUIRE(asked.calls.size() == 4);
  std::uint64_t sampled_points = 0;
  for (int n = 1; n <= 4; ++n) {
    const auto& points = asked.calls[static_cast<std::size_t>(n - 1)];
    sampled_points += points.size();
    std::set<std::pair<double, double>> needed;  // y, x
    const EdgeMap coarser = expected_map(plane, 9, 8, n - 1);
    const double side = 1.0 / (1 << n);
    for (int y = 0; y < coarser.height; ++y) {
      for (int x = 0; x < coarser.width; ++x) {
        for (int i = 0; coarser.at(x, y) && i < 9; ++i) {
          if (const int px = i % 3, py = i / 3; px == 1 || py == 1) {
            needed.emplace((2 * y + py) * side, (2 * x + px) * side);
          }
        }
      }
    }
    std::vector<glm::dvec2> in_raster_order;
    for (const auto& [y, x] : needed) {
      in_raster_order.emplace_back(x, y);
    }
    CHECK(points == in_raster_order);
  }
  CHECK(refined.sampled == sampled_points);
}

TEST_CASE("each marked square holds a marked subsquare", "[edges][refine]") {
  CHECK(rc::check("random lattice and random samples", [] {
    CategoryImage image{.width = 5, .height = 4};
    for (int i = 0; i < 30; ++i) {
      image.samples.push_back(CategoryId{*rc::gen::inRange<std::uint32_t>(0, 3)});
    }
    const auto seed = *rc::gen::arbitrary<std::uint32_t>();
    const CategorySampler random = [&](std::span<const glm::dvec2> points) {
      std::vector<CategoryId> ids;
      for (const glm::dvec2& p : points) {
        const std::array words{seed, static_cast<std::uint32_t>(64 * p.x),
                               static_cast<std::uint32_t>(64 * p.y)};
        ids.push_back(CategoryId{static_cast<std::uint32_t>(hash_words(words) >> 8) % 3});
      }
      return ids;
    };
    EdgeMap coarse = detect_edges(image);
    for (int n = 1; n <= 3; ++n) {
      EdgeMap fine = refine_edges(image, n, random).map;
      for (int y = 0; y < coarse.height; ++y) {
        for (int x = 0; x < coarse.width; ++x) {
          const bool held = fine.at(2 * x, 2 * y) || fine.at(2 * x + 1, 2 * y) ||
                            fine.at(2 * x, 2 * y + 1) || fine.at(2 * x + 1, 2 * y + 1);
          RC_ASSERT(held == coarse.at(x, y));
        }
      }
      coarse = std::move(fine);
    }
  }));
}

TEST_CASE("a map too wide to number is refused", "[edges][refine]") {
  const CategoryImage image{.width = 1 << 25, .height = 0};
  CHECK_THROWS_WITH(refine_edges(image, 6, {}),
                    "refined edge maps hold at most 2147483647 subpixels a side");
}

}  // namespace
}  // namespace raycat
