#include "geometry/mesh_faces.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "geometry/coincident_twins.hpp"
#include "geometry/crease.hpp"
#include "geometry/disjoint_sets.hpp"
#include "geometry/edge_parts.hpp"
#include "geometry/edge_uses.hpp"
#include "geometry/raw_array.hpp"
#include "geometry/weld.hpp"
#include "threads/parallel.hpp"

namespace raycat {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Welded triangles, and which of them are of one face.
class FaceGrouping {
 public:
  FaceGrouping(std::span<const glm::dvec3> positions, std::span<const glm::uvec3> triangles,
               std::span<const glm::vec3> normals, const FaceRule& rule, int threads)
      : positions_(positions),
        triangles_(triangles),
        authored_normals_(normals),
        threads_(threads),
        welded_(weld(positions, threads)),
        vertices_(welded(triangles, welded_, threads)),
        normals_(unit_normals(positions)),
        same_normal_(std::cos(rule.same_normal + crease_slack)),
        crease_(rule.crease),
        edges_(vertices_, positions.size(), threads),
        sets_(triangles.size()) {}

  // `edges_` looks at `vertices_`.
  FaceGrouping(const FaceGrouping&) = delete;
  FaceGrouping& operator=(const FaceGrouping&) = delete;

  void join_smooth_edges() {
    parallel_parts(edges_.vertices(), threads_, [&](std::size_t begin, std::size_t end, int) {
      std::vector<TriangleCopy> copies;
      std::vector<std::uint32_t> open;
      edges_.for_each(begin, end, [&](std::span<const std::uint32_t> uses) {
        add_copies(vertices_, uses, copies);
        join_smooth(uses, open);
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

  /// Spreads faces over degenerate triangles, from edge to edge and then through vertices, for
  /// those without an edge.
  void adopt_degenerate_triangles() {
    if (!some_degenerate_) {
      return;
    }
    std::vector<std::uint32_t> settled;
    for (std::uint32_t i = 0; i < normals_.size(); ++i) {
      if (!degenerate(i)) {
        settled.push_back(i);
      }
    }
    // The next half-edge of the same edge, round and round; none of one that is no edge's.
    std::vector<std::uint32_t> round(3 * vertices_.size(), none);
    edges_.for_each([&](std::span<const std::uint32_t> uses) {
      for (std::size_t i = 0; i < uses.size(); ++i) {
        round[uses[i]] = uses[(i + 1) % uses.size()];
      }
    });
    std::vector<bool> is_settled(vertices_.size(), false);
    for (const std::uint32_t i : settled) {
      is_settled[i] = true;
    }
    for (std::size_t next = 0; next < settled.size(); ++next) {
      const std::uint32_t triangle = settled[next];
      for (std::uint32_t half = 3 * triangle; half < 3 * triangle + 3; ++half) {
        // An edge is gone round once.
        for (std::uint32_t use = std::exchange(round[half], none); use != none;
             use = std::exchange(round[use], none)) {
          if (!is_settled[use / 3]) {
            is_settled[use / 3] = true;
            settled.push_back(use / 3);
            sets_.join(triangle, use / 3);
          }
        }
      }
    }
    adopt_through_vertices(is_settled);
  }

  /// The lowest-numbered triangle of the same face.
  std::uint32_t first_of_face(std::uint32_t triangle) noexcept { return sets_.first(triangle); }

  std::vector<std::uint32_t> twins() const { return twins_of(copies_, triangles_.size()); }

 private:
  RawArray<glm::dvec3> unit_normals(std::span<const glm::dvec3> positions) {
    RawArray<glm::dvec3> out(triangles_.size());
    parallel_parts(out.size(), threads_, [&](std::size_t begin, std::size_t end, int) {
      bool degenerate = false;
      for (std::size_t i = begin; i < end; ++i) {
        const glm::uvec3& t = triangles_[i];
        out[i] = unit_normal(positions[t.x], positions[t.y], positions[t.z]);
        degenerate = degenerate || out[i] == glm::dvec3(0.0);
      }
      if (degenerate) {
        some_degenerate_ = true;
      }
    });
    return out;
  }

  // Zero for a triangle whose height is nothing beside its longest side.
  static glm::dvec3 unit_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    constexpr double least_height = 1e-10;
    const glm::dvec3 ab = b - a;
    const glm::dvec3 ac = c - a;
    const glm::dvec3 bc = c - b;
    const glm::dvec3 normal = glm::cross(ab, ac);
    const double length = glm::length(normal);
    const double longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
    return length > least_height * longest ? normal / length : glm::dvec3(0.0);
  }

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

  // A triangle's side along an edge, or part of one.
  struct Side {
    std::uint32_t half = none;
    double from = 0.0;
    double to = 1.0;
  };

  // A surface at an edge: the side of a triangle that runs along it upwards, from the lower vertex,
  // and that of one downwards. Both, if it is stored both ways round.
  struct EdgeSurface {
    std::uint32_t apex = none;
    Side upwards;
    Side downwards;
  };

  // Adds half-edges of edges that only one surface has to `open`.
  void join_smooth(std::span<const std::uint32_t> uses, std::vector<std::uint32_t>& open) {
    if (uses.size() == 1) {
      open.push_back(uses.front());
      return;
    }
    if (uses.size() == 2 && apex(uses[0]) != apex(uses[1]) && !some_degenerate_) {
      const bool opposite = start(uses[0]) != start(uses[1]);
      if (smooth({.half = uses[0]}, {.half = uses[1]}, opposite)) {
        sets_.join(uses[0] / 3, uses[1] / 3);
      }
      return;
    }
    const std::uint32_t low = std::min(start(uses.front()), half_edge_end(vertices_, uses.front()));
    std::vector<EdgeSurface> surfaces;
    for (const std::uint32_t use : uses) {
      surfaces.push_back(surface({.half = use}, start(use) == low));
    }
    join_smooth_surfaces(surfaces);
    const auto areas = std::ranges::count_if(
        surfaces, [&](const EdgeSurface& surface) { return !degenerate(triangle_of(surface)); });
    for (const EdgeSurface& surface : surfaces) {
      if (areas == 1 && !degenerate(triangle_of(surface))) {
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

  EdgeSurface surface(const Side& side, bool upwards) const {
    return {.apex = apex(side.half),
            .upwards = upwards ? side : Side(),
            .downwards = upwards ? Side() : side};
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
    const auto join_if_smooth = [&](const Side& a, const Side& b, bool opposite) {
      if (a.half != none && b.half != none && smooth(a, b, opposite)) {
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

  bool degenerate(std::uint32_t triangle) const { return normals_[triangle] == glm::dvec3(0.0); }

  std::uint32_t start(std::uint32_t half) const { return half_edge_start(vertices_, half); }

  std::uint32_t apex(std::uint32_t half) const { return half_edge_apex(vertices_, half); }

  bool smooth(const Side& a, const Side& b, bool opposite) const {
    const std::uint32_t triangle = a.half / 3;
    const std::uint32_t other = b.half / 3;
    if (degenerate(triangle) || degenerate(other)) {
      return false;
    }
    const glm::dvec3 turned = opposite ? normals_[other] : -normals_[other];
    const auto tilts = [&] { return tilt(triangle) + tilt(other); };
    if (crease_.joins(normals_[triangle], turned, tilts)) {
      return true;
    }
    if (authored_normals_.empty()) {
      return false;
    }
    const double b_start = opposite ? b.to : b.from;
    const double b_end = opposite ? b.from : b.to;
    return same_normals(authored_normal(a.half, a.from), authored_normal(b.half, b_start)) &&
           same_normals(authored_normal(a.half, a.to), authored_normal(b.half, b_end));
  }

  double tilt(std::uint32_t triangle) const {
    const glm::uvec3& t = triangles_[triangle];
    return rounding_tilt({positions_[t.x], positions_[t.y], positions_[t.z]});
  }

  // False if either is zero or not finite.
  bool same_normals(const glm::dvec3& a, const glm::dvec3& b) const {
    const double lengths = std::sqrt(glm::dot(a, a) * glm::dot(b, b));
    return lengths > 0.0 && std::isfinite(lengths) && glm::dot(a, b) >= same_normal_ * lengths;
  }

  // At a point of a half-edge, in parts of its length.
  glm::dvec3 authored_normal(std::uint32_t half, double at) const {
    const glm::dvec3 from(authored_normals_[half_edge_start(triangles_, half)]);
    const glm::dvec3 to(authored_normals_[half_edge_end(triangles_, half)]);
    return at == 0.0 ? from : (at == 1.0 ? to : glm::mix(from, to, at));
  }

  void adopt_through_vertices(std::vector<bool>& is_settled) {
    std::vector<std::uint32_t> triangle_at;  // by vertex; made if ever needed
    for (std::uint32_t i = 0; i < vertices_.size(); ++i) {
      if (is_settled[i]) {
        continue;
      }
      if (triangle_at.empty()) {
        triangle_at = settled_by_vertex(is_settled);
      }
      for (int k = 0; k < 3; ++k) {
        if (triangle_at[vertices_[i][k]] != none) {
          sets_.join(i, triangle_at[vertices_[i][k]]);
          break;
        }
      }
    }
  }

  std::vector<std::uint32_t> settled_by_vertex(const std::vector<bool>& is_settled) const {
    std::uint32_t last = 0;
    for (const glm::uvec3& t : vertices_) {
      last = std::max({last, t.x, t.y, t.z});
    }
    std::vector<std::uint32_t> triangle_at(std::size_t{last} + 1, none);
    for (std::uint32_t i = 0; i < vertices_.size(); ++i) {
      for (int k = 0; is_settled[i] && k < 3; ++k) {
        triangle_at[vertices_[i][k]] = std::min(triangle_at[vertices_[i][k]], i);
      }
    }
    return triangle_at;
  }

  std::span<const glm::dvec3> positions_;
  std::span<const glm::uvec3> triangles_;
  std::span<const glm::vec3> authored_normals_;  // of `triangles_`' vertices, not of welded ones
  int threads_;
  std::vector<std::uint32_t> welded_;
  RawArray<glm::uvec3> vertices_;
  std::atomic<bool> some_degenerate_ = false;  // before `normals_`, which tell
  RawArray<glm::dvec3> normals_;               // zero for degenerate ones
  double same_normal_;
  Crease crease_;
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
