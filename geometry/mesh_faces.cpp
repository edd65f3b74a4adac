#include "geometry/mesh_faces.hpp"

#include <algorithm>
#include <cassert>
#include <mutex>
#include <numbers>

#include "geometry/coincident_twins.hpp"
#include "geometry/continuation.hpp"
#include "geometry/degenerate_triangles.hpp"
#include "geometry/disjoint_sets.hpp"
#include "geometry/edge_parts.hpp"
#include "geometry/edge_uses.hpp"
#include "geometry/raw_array.hpp"
#include "geometry/weld.hpp"
#include "threads/parallel.hpp"

namespace raycat {
namespace {

constexpr std::uint32_t none = TriangleSide::none;

// A surface at an edge: the side of a triangle that runs along it upwards, from the lower vertex,
// and that of one downwards. Both, if it is stored both ways round.
struct EdgeSurface {
  std::uint32_t apex = none;
  TriangleSide upwards;
  TriangleSide downwards;
};

/// Welded triangles, and which of them are of one face.
class FaceGrouping {
 public:
  FaceGrouping(std::span<const glm::dvec3> positions, std::span<const glm::uvec3> triangles,
               std::span<const glm::vec3> normals, const FaceRule& rule, int threads)
      : positions_(positions),
        triangles_(triangles),
        threads_(threads),
        welded_(weld(positions, threads)),
        vertices_(welded(triangles, welded_, threads)),
        continues_(positions, triangles, normals, rule, threads),
        edges_(vertices_, positions.size(), threads),
        sets_(triangles.size()) {}

  // `edges_` looks at `vertices_`.
  FaceGrouping(const FaceGrouping&) = delete;
  FaceGrouping& operator=(const FaceGrouping&) = delete;

  void join_smooth_edges() {
    parallel_parts(edges_.vertices(), threads_, [&](std::size_t begin, std::size_t end, int) {
      std::vector<TriangleCopy> copies;
      std::vector<std::uint32_t> open;
      std::vector<EdgeSurface> surfaces;  // of an edge, kept for its memory
      edges_.for_each(begin, end, [&](std::span<const std::uint32_t> uses) {
        join_smooth(uses, open, surfaces, copies);
      });
      join_copies(copies);
      const std::lock_guard lock(adding_);
      open_.insert(open_.end(), open.begin(), open.end());
    });
    if (!open_.empty()) {
      join_over_vertices_on_edges();
    }
  }

  /// Joins what shares an edge, but for the edges between two of the points given.
  void join_all_but(std::span<const glm::uvec2> borders) {
    std::vector<std::uint64_t> kept_apart;
    for (const glm::uvec2& border : borders) {
      kept_apart.push_back(edge_key(welded_[border.x], welded_[border.y]));
    }
    std::ranges::sort(kept_apart);
    std::vector<TriangleCopy> copies;
    edges_.for_each([&](std::span<const std::uint32_t> uses) {
      add_copies(vertices_, uses, copies);
      const std::uint64_t key =
          edge_key(start(uses.front()), half_edge_end(vertices_, uses.front()));
      if (!std::ranges::binary_search(kept_apart, key)) {
        for (const std::uint32_t use : uses.subspan(1)) {
          sets_.join(uses.front() / 3, use / 3);
        }
      }
    });
    join_copies(copies);
  }

  void adopt_degenerate_triangles() {
    if (!continues_.some_degenerate()) {
      return;
    }
    std::vector<bool> is_degenerate(triangles_.size());
    for (std::uint32_t i = 0; i < is_degenerate.size(); ++i) {
      is_degenerate[i] = continues_.degenerate(i);
    }
    spread_over(is_degenerate, vertices_, edges_, sets_);
  }

  /// The lowest-numbered triangle of the same face.
  std::uint32_t first_of_face(std::uint32_t triangle) noexcept { return sets_.first(triangle); }

  std::vector<std::uint32_t> twins() const { return twins_of(copies_, triangles_.size()); }

 private:
  static std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
  }

  void join_copies(std::span<const TriangleCopy> copies) {
    for (const TriangleCopy& copy : copies) {
      sets_.join(copy.triangle, copy.kept);
    }
    const std::lock_guard lock(adding_);
    copies_.insert(copies_.end(), copies.begin(), copies.end());
  }

  // Adds half-edges of edges that only one surface has to `open`, and copies to `copies`.
  void join_smooth(std::span<const std::uint32_t> uses, std::vector<std::uint32_t>& open,
                   std::vector<EdgeSurface>& surfaces, std::vector<TriangleCopy>& copies) {
    if (uses.size() == 1) {
      open.push_back(uses.front());
      return;
    }
    const bool of_two_surfaces = uses.size() == 2 && apex(uses[0]) != apex(uses[1]);
    if (of_two_surfaces && !continues_.some_degenerate()) {
      const bool opposite = start(uses[0]) != start(uses[1]);
      if (continues_.over({.half = uses[0]}, {.half = uses[1]}, opposite)) {
        sets_.join(uses[0] / 3, uses[1] / 3);
      }
      return;
    }
    const std::uint32_t low = std::min(start(uses.front()), half_edge_end(vertices_, uses.front()));
    if (!of_two_surfaces) {
      add_copies(vertices_, uses, copies);
    }
    surfaces.clear();
    for (const std::uint32_t use : uses) {
      surfaces.push_back(surface({.half = use}, start(use) == low));
    }
    join_smooth_surfaces(surfaces);
    const auto areas = std::ranges::count_if(surfaces, [&](const EdgeSurface& surface) {
      return !continues_.degenerate(triangle_of(surface));
    });
    for (const EdgeSurface& surface : surfaces) {
      if (areas == 1 && !continues_.degenerate(triangle_of(surface))) {
        open.push_back(surface.upwards.half != none ? surface.upwards.half
                                                    : surface.downwards.half);
      }
    }
  }

  // Edges that end inside others, as they do in floors that are cut into rows of unequal pieces.
  void join_over_vertices_on_edges() {
    std::ranges::sort(open_);
    std::vector<EdgeSurface> surfaces;
    for_each_place(edge_parts(positions_, vertices_, open_, edge_tolerance(positions_), threads_),
                   [&](std::span<const EdgePart> parts) {
                     if (parts.size() == 1) {
                       return;
                     }
                     surfaces.clear();
                     for (const EdgePart& part : parts) {
                       surfaces.push_back(surface(
                           {.half = part.half, .from = part.from, .to = part.to}, part.upwards));
                     }
                     join_smooth_surfaces(surfaces);
                   });
  }

  EdgeSurface surface(const TriangleSide& side, bool upwards) const {
    return {.apex = apex(side.half),
            .upwards = upwards ? side : TriangleSide(),
            .downwards = upwards ? TriangleSide() : side};
  }

  static std::uint32_t triangle_of(const EdgeSurface& surface) {
    return std::min(surface.upwards.half, surface.downwards.half) / 3;
  }

  // Triangles with one apex are one surface.
  static void unite_copies(std::vector<EdgeSurface>& surfaces) {
    std::ranges::stable_sort(surfaces, {}, &EdgeSurface::apex);
    std::size_t kept = 0;
    for (std::size_t i = 1; i < surfaces.size(); ++i) {
      if (surfaces[i].apex != surfaces[kept].apex) {
        surfaces[++kept] = surfaces[i];
        continue;
      }
      if (surfaces[kept].upwards.half == none) {
        surfaces[kept].upwards = surfaces[i].upwards;
      }
      if (surfaces[kept].downwards.half == none) {
        surfaces[kept].downwards = surfaces[i].downwards;
      }
    }
    surfaces.resize(kept + 1);
  }

  void join_smooth_surfaces(std::vector<EdgeSurface>& surfaces) {
    unite_copies(surfaces);
    // So many surfaces around one edge are none, and all their pairs too many to try.
    constexpr std::size_t most_around_edge = 64;
    if (surfaces.size() > most_around_edge) {
      return;
    }
    const auto join_if_smooth = [&](const TriangleSide& a, const TriangleSide& b, bool opposite) {
      if (a.half != none && b.half != none && continues_.over(a, b, opposite)) {
        sets_.join(a.half / 3, b.half / 3);
      }
    };
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      for (std::size_t j = i + 1; j < surfaces.size(); ++j) {
        join_if_smooth(surfaces[i].upwards, surfaces[j].downwards, true);
        join_if_smooth(surfaces[i].downwards, surfaces[j].upwards, true);
        if (surfaces.size() == 2) {
          join_if_smooth(surfaces[i].upwards, surfaces[j].upwards, false);
          join_if_smooth(surfaces[i].downwards, surfaces[j].downwards, false);
        }
      }
    }
  }

  std::uint32_t start(std::uint32_t half) const { return half_edge_start(vertices_, half); }

  std::uint32_t apex(std::uint32_t half) const { return half_edge_apex(vertices_, half); }

  std::span<const glm::dvec3> positions_;
  std::span<const glm::uvec3> triangles_;
  int threads_;
  std::vector<std::uint32_t> welded_;
  RawArray<glm::uvec3> vertices_;
  Continuation continues_;
  EdgeUses edges_;
  DisjointSets sets_;
  std::mutex adding_;
  std::vector<TriangleCopy> copies_;
  std::vector<std::uint32_t> open_;  // half-edges that are the only ones of their edges
};

std::vector<std::uint32_t> numbered(FaceGrouping& grouping, std::size_t triangles) {
  std::vector<std::uint32_t> faces(triangles);
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    const std::uint32_t first = grouping.first_of_face(i);
    faces[i] = first == i ? count++ : faces[first];
  }
  return faces;
}

}  // namespace

MeshFaces group_faces(std::span<const glm::dvec3> positions, std::span<const glm::uvec3> triangles,
                      std::span<const glm::vec3> normals, const FaceRule& rule, int threads) {
  assert(normals.empty() || normals.size() == positions.size());
  assert(rule.crease >= 0.0 && rule.crease <= std::numbers::pi);
  FaceGrouping grouping(positions, triangles, normals, rule, threads);
  grouping.join_smooth_edges();
  grouping.adopt_degenerate_triangles();
  return {.faces = numbered(grouping, triangles.size()), .twins = grouping.twins()};
}

MeshFaces group_faces_between(std::span<const glm::dvec3> positions,
                              std::span<const glm::uvec3> triangles,
                              std::span<const glm::uvec2> borders, int threads) {
  FaceGrouping grouping(positions, triangles, {}, {}, threads);
  grouping.join_all_but(borders);
  return {.faces = numbered(grouping, triangles.size()), .twins = grouping.twins()};
}

}  // namespace raycat
