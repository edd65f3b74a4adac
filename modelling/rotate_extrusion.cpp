#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "modelling/extrusion.hpp"
#include "modelling/smooth_runs.hpp"
#include "modelling/triangulation.hpp"

namespace raycat {
namespace {

std::pair<double, double> reach(const Polygons& polygons) {
  double left = 0.0;
  double right = 0.0;
  for (const Contour& contour : polygons.contours) {
    for (const glm::dvec2& corner : contour) {
      left = std::min(left, corner.x);
      right = std::max(right, corner.x);
    }
  }
  return {left, right};
}

bool is_full_turn(double angle) { return !(std::abs(angle) < 360.0); }

// A counter-clockwise turn, of what lies right of the axis.
struct Sweep {
  Polygons profile;
  double start;
  double angle;
  std::uint32_t fragments;
  bool full;
};

Sweep sweep(const Polygons& polygons, const RotateExtrusion& extrusion) {
  const auto [left, right] = reach(polygons);
  if (left < 0.0 && right > 0.0) {
    throw std::invalid_argument(
        fmt::format("a rotate extrusion needs a profile on one side of the y axis, but x goes from "
                    "{:g} to {:g}",
                    left, right));
  }
  Sweep out{.profile = polygons,
            .start = std::min(extrusion.angle, 0.0),
            .angle = std::abs(extrusion.angle),
            .fragments = extrusion.fragments,
            .full = is_full_turn(extrusion.angle)};
  if (out.full) {
    out.start = 180.0;
    out.angle = 360.0;
  }
  if (left < 0.0) {
    out.profile = transformed(polygons, {{-1.0, 0.0}, {0.0, 1.0}, {0.0, 0.0}});
    out.start += 180.0;
  }
  return out;
}

// The corners of every step, and which is which: those on the axis are at one place in all steps,
// and the last step of a full turn is the first.
class Rings {
 public:
  Rings(const Sweep& sweep, TriangleMesh& mesh) : mesh_(mesh) {
    for (const Contour& contour : sweep.profile.contours) {
      corners_.insert(corners_.end(), contour.begin(), contour.end());
    }
    rings_ = sweep.full ? sweep.fragments : sweep.fragments + 1;
    if (corners_.size() > std::numeric_limits<std::uint32_t>::max() / rings_) {
      throw std::length_error("a rotate extrusion has 2^32 corners or more");
    }
    mesh.positions.reserve(rings_ * corners_.size());
    for (std::uint32_t ring = 0; ring < rings_; ++ring) {
      const glm::dvec2 towards = unit_vector(sweep.start + sweep.angle * ring / sweep.fragments);
      for (const glm::dvec2& corner : corners_) {
        mesh.positions.emplace_back(corner.x * towards, corner.y);
      }
    }
  }

  std::uint32_t operator()(std::uint32_t ring, std::uint32_t corner) const {
    const auto all = static_cast<std::uint32_t>(corners_.size());
    return corners_[corner].x == 0.0 ? corner : ring % rings_ * all + corner;
  }

  void add(const glm::uvec3& triangle, std::uint32_t face) {
    if (triangle.x != triangle.y && triangle.y != triangle.z && triangle.z != triangle.x) {
      mesh_.triangles.push_back(triangle);
      mesh_.faces.push_back(face);
      mesh_.face_count = std::max(mesh_.face_count, face + 1);
    }
  }

 private:
  TriangleMesh& mesh_;
  std::vector<glm::dvec2> corners_;
  std::uint32_t rings_;
};

void add_caps(const std::vector<glm::uvec3>& caps, std::uint32_t last, Rings& rings) {
  for (const glm::uvec3& t : caps) {
    rings.add({rings(0, t.x), rings(0, t.y), rings(0, t.z)}, 0);
    rings.add({rings(last, t.z), rings(last, t.y), rings(last, t.x)}, 1);
  }
}

// From corner a to corner b of the profile, round all the way.
void add_band(std::uint32_t a, std::uint32_t b, std::uint32_t fragments, std::uint32_t face,
              Rings& rings) {
  for (std::uint32_t ring = 0; ring < fragments; ++ring) {
    const std::uint32_t next = ring + 1;
    rings.add({rings(ring, a), rings(next, a), rings(next, b)}, face);
    rings.add({rings(ring, a), rings(next, b), rings(ring, b)}, face);
  }
}

void add_walls(const Sweep& sweep, const TriangleMesh& mesh, Rings& rings) {
  std::uint32_t first = 0;
  for (const Contour& contour : sweep.profile.contours) {
    const auto n = static_cast<std::uint32_t>(contour.size());
    const std::vector<std::uint32_t> runs = smooth_runs(contour);
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> face(n, none);  // of each run, once it has one
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t next = (i + 1) % n;
      if (contour[i].x == 0.0 && contour[next].x == 0.0) {
        continue;
      }
      std::uint32_t& number = face[runs[i]];
      if (number == none) {
        number = mesh.face_count;
      }
      add_band(first + i, first + next, sweep.fragments, number, rings);
    }
    first += n;
  }
}

}  // namespace

std::uint32_t default_fragments(const Polygons& polygons, double angle, const FacetRule& rule) {
  const auto [left, right] = reach(polygons);
  const std::uint32_t around = facet_count(right - left, rule);
  return is_full_turn(angle)
             ? around
             : std::max(static_cast<std::uint32_t>(around * std::abs(angle) / 360.0), 1U);
}

TriangleMesh rotate_extrusion(const Polygons& polygons, const RotateExtrusion& extrusion) {
  TriangleMesh mesh;
  Sweep turn = sweep(polygons, extrusion);
  if (turn.angle == 0.0) {
    return mesh;
  }
  Triangulation caps = triangulated(std::move(turn.profile));
  if (caps.triangles.empty()) {
    return mesh;
  }
  turn.profile = std::move(caps.polygons);
  Rings rings(turn, mesh);
  if (!turn.full) {
    add_caps(caps.triangles, turn.fragments, rings);
  }
  add_walls(turn, mesh, rings);
  return mesh;
}

}  // namespace raycat
