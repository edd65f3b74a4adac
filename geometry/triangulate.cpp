#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "geometry/mesh_faces.hpp"

namespace raycat {
namespace {

using Polygon = std::vector<std::uint32_t>;

void check(const Polygon& polygon, std::size_t face, std::size_t point_count) {
  if (polygon.size() < 3) {
    throw std::invalid_argument(
        fmt::format("face {} needs at least 3 corners, but has {}", face, polygon.size()));
  }
  for (const std::uint32_t corner : polygon) {
    if (corner >= point_count) {
      throw std::invalid_argument(
          fmt::format("face {} has corner {}, but there are {} points", face, corner, point_count));
    }
  }
}

/// Cuts ears off one polygon. Whatever the polygon, the triangles' edges are the polygon's edges
/// and edges used once each way, so that a closed mesh stays closed.
class EarClipper {
 public:
  EarClipper(std::span<const glm::dvec3> points, const Polygon& polygon,
             std::vector<glm::uvec3>& out)
      : points_(points), polygon_(polygon), out_(out) {}

  void run() {
    project();
    if (!cut_fan()) {
      cut_ears();
    }
  }

 private:
  // Leaves out the axis that the polygon faces most, which rounds nothing.
  void project() {
    glm::dvec3 normal(0.0);  // Newell's, about the first corner so that a far one loses nothing
    const glm::dvec3& origin = points_[polygon_[0]];
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      normal += glm::cross(points_[polygon_[i]] - origin,
                           points_[polygon_[(i + 1) % polygon_.size()]] - origin);
    }
    const glm::dvec3 size = glm::abs(normal);
    const int z = size.x > size.y && size.x > size.z ? 0 : (size.y > size.z ? 1 : 2);
    int x = (z + 1) % 3;
    int y = (z + 2) % 3;
    if (normal[z] < 0.0) {
      std::swap(x, y);
    }
    flat_.reserve(polygon_.size());
    for (const std::uint32_t corner : polygon_) {
      flat_.emplace_back(points_[corner][x], points_[corner][y]);
    }
  }

  // 1 if a, b, c turn left, -1 if right, 0 if they are in a row up to rounding.
  int turn(std::size_t a, std::size_t b, std::size_t c) const {
    constexpr double least_sine = 1e-12;
    const glm::dvec2 ab = flat_[b] - flat_[a];
    const glm::dvec2 ac = flat_[c] - flat_[a];
    const glm::dvec2 bc = flat_[c] - flat_[b];
    const double area = ab.x * ac.y - ab.y * ac.x;
    const double longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
    const double margin = least_sine * longest;
    return static_cast<int>(area > margin) - static_cast<int>(area < -margin);
  }

  // A polygon that its first corner sees all of, going round once.
  bool cut_fan() {
    const std::size_t n = polygon_.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (turn(i, (i + 1) % n, (i + 2) % n) <= 0 ||
          (i > 0 && i + 1 < n && turn(0, i, i + 1) <= 0)) {
        return false;
      }
    }
    for (std::size_t i = 1; i + 1 < n; ++i) {
      out_.emplace_back(polygon_[0], polygon_[i], polygon_[i + 1]);
    }
    return true;
  }

  void cut_ears() {
    const std::size_t n = polygon_.size();
    previous_.resize(n);
    next_.resize(n);
    is_cut_.assign(n, false);
    for (std::size_t i = 0; i < n; ++i) {
      previous_[i] = (i + n - 1) % n;
      next_[i] = (i + 1) % n;
      candidates_.push_back(i);
    }
    // A corner that is no ear becomes one only when a neighbour goes, so that each cut adds two
    // candidates, and each is compared with all corners once.
    std::size_t current = 0;
    for (std::size_t left = n; left > 3;) {
      std::size_t ear = 0;
      if (candidates_.empty()) {
        // Only polygons that cross themselves or have no area come here.
        ear = least_bad(current);
      } else {
        ear = candidates_.front();
        candidates_.pop_front();
        if (is_cut_[ear] || !(is_spike(ear) || is_ear(ear))) {
          continue;
        }
      }
      current = next_[ear];
      cut(ear);
      --left;
    }
    emit(previous_[current], current, next_[current]);
  }

  std::size_t least_bad(std::size_t current) const {
    std::size_t i = current;
    do {
      if (turn(previous_[i], i, next_[i]) > 0) {
        return i;
      }
      i = next_[i];
    } while (i != current);
    return current;
  }

  // Repeats a neighbour, or goes to a place and straight back.
  bool is_spike(std::size_t i) const {
    return flat_[i] == flat_[next_[i]] || flat_[i] == flat_[previous_[i]] ||
           flat_[previous_[i]] == flat_[next_[i]];
  }

  // Corners on the ear's border count as in it, or a later ear would be without area; those at
  // its own corners do not, so that a bridge to a hole, used both ways, is no obstacle.
  bool is_ear(std::size_t i) const {
    const std::size_t a = previous_[i];
    const std::size_t c = next_[i];
    if (turn(a, i, c) <= 0) {
      return false;
    }
    for (std::size_t k = next_[c]; k != a; k = next_[k]) {
      const bool at_corner = flat_[k] == flat_[a] || flat_[k] == flat_[i] || flat_[k] == flat_[c];
      if (!at_corner && turn(a, i, k) >= 0 && turn(i, c, k) >= 0 && turn(c, a, k) >= 0) {
        return false;
      }
    }
    return true;
  }

  void cut(std::size_t i) {
    emit(previous_[i], i, next_[i]);
    is_cut_[i] = true;
    next_[previous_[i]] = next_[i];
    previous_[next_[i]] = previous_[i];
    candidates_.push_back(previous_[i]);
    candidates_.push_back(next_[i]);
  }

  // Two corners at one place use an edge both ways, which needs no triangle.
  void emit(std::size_t a, std::size_t b, std::size_t c) {
    const glm::dvec3& pa = points_[polygon_[a]];
    const glm::dvec3& pb = points_[polygon_[b]];
    const glm::dvec3& pc = points_[polygon_[c]];
    if (pa != pb && pb != pc && pc != pa) {
      out_.emplace_back(polygon_[a], polygon_[b], polygon_[c]);
    }
  }

  std::span<const glm::dvec3> points_;
  const Polygon& polygon_;
  std::vector<glm::uvec3>& out_;
  std::vector<glm::dvec2> flat_;
  std::vector<std::size_t> previous_, next_;
  std::vector<bool> is_cut_;
  std::deque<std::size_t> candidates_;
};

}  // namespace

TriangleMesh triangulate(std::vector<glm::dvec3> points, std::span<const Polygon> faces,
                         std::span<const std::uint32_t> face_of) {
  assert(face_of.empty() || face_of.size() == faces.size());
  TriangleMesh mesh{.positions = std::move(points), .triangles = {}, .faces = {}};
  for (std::size_t i = 0; i < faces.size(); ++i) {
    check(faces[i], i, mesh.positions.size());
    EarClipper(mesh.positions, faces[i], mesh.triangles).run();
    const std::uint32_t face = face_of.empty() ? static_cast<std::uint32_t>(i) : face_of[i];
    mesh.faces.resize(mesh.triangles.size(), face);
    mesh.face_count = std::max(mesh.face_count, face + 1);
  }
  return mesh;
}

}  // namespace raycat
