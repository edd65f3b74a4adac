#include "modelling/flush_planes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "geometry/bounds.hpp"

namespace raycat {
namespace {

using Exactly = Exact::Exact_kernel;

constexpr std::uint32_t none = FlushTriangles::none;
constexpr double cell = 1e-3;                // of normals, and of offsets by the size of the whole
constexpr double noise = 1e-5;               // by which those of one plane may differ
constexpr double normal_steps = 67108864.0;  // 2^26, into which normals are rounded
constexpr double offset_steps = 17179869184.0;  // 2^34, offsets by the size of the whole
constexpr double least_crossing = 1e-3;  // sine of the angle between planes that fix a corner

// A plane through the largest of the triangles that lie in it.
struct Plane {
  glm::dvec3 normal{0.0};  // unit
  double offset = 0.0;     // from the middle of the whole
  std::uint32_t triangle = 0;
  std::uint32_t owner = 0;
  bool shared = false;  // by two owners
};

class Planes {
 public:
  // Those that are spanned come first.
  Planes(std::span<const glm::dvec3> positions, std::span<const glm::uvec3> triangles,
         std::span<const std::uint32_t> spanning, double tolerance)
      : positions_(positions), triangles_(triangles), tolerance_(tolerance) {
    Bounds box;
    for (const glm::dvec3& position : positions) {
      box.include(position);
    }
    if (!box.empty()) {
      middle_ = box.center();
      size_ = std::max(glm::length(box.half_size()), std::numeric_limits<double>::min());
    }
    for (const std::uint32_t triangle : spanning) {
      Plane plane{.triangle = triangle, .shared = true};
      if (triangle != none) {
        const std::array<glm::dvec3, 3> corners = corners_of(triangle);
        plane.normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
      }
      planes.push_back(plane);
    }
  }

  // The plane of a triangle, `none` if it has no direction. Larger triangles must come first.
  std::uint32_t add(std::uint32_t triangle, std::uint32_t owner) {
    const std::array<glm::dvec3, 3> corners = corners_of(triangle);
    const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = glm::length(across);
    if (!(length > 0.0)) {
      return none;
    }
    const glm::dvec3 normal = across / length;
    const double offset = glm::dot(normal, corners[0]);
    std::uint32_t found = find(normal, offset, corners);
    if (found == none) {
      found = find(-normal, -offset, corners);
    }
    if (found == none) {
      found = static_cast<std::uint32_t>(planes.size());
      planes.push_back({.normal = normal, .offset = offset, .triangle = triangle, .owner = owner});
      in_cell_.emplace(
          key(index(normal.x), index(normal.y), index(normal.z), index(offset / size_)), found);
    }
    planes[found].shared = planes[found].shared || planes[found].owner != owner;
    return found;
  }

  double size() const { return size_; }

  std::vector<Plane> planes;

 private:
  std::array<glm::dvec3, 3> corners_of(std::uint32_t triangle) const {
    const glm::uvec3& t = triangles_[triangle];
    return {positions_[t.x] - middle_, positions_[t.y] - middle_, positions_[t.z] - middle_};
  }

  static std::int64_t index(double value) {
    return static_cast<std::int64_t>(std::floor(value / cell));
  }

  static std::uint64_t key(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    std::uint64_t hash = 0;
    for (const std::int64_t part : {a, b, c, d}) {
      hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 29U;
    }
    return hash;
  }

  std::uint32_t find(const glm::dvec3& normal, double offset,
                     const std::array<glm::dvec3, 3>& corners) const {
    const std::array values{normal.x, normal.y, normal.z, offset / size_};
    std::array<std::int64_t, 4> low{};
    std::array<std::int64_t, 4> high{};
    for (std::size_t i = 0; i < 4; ++i) {
      low[i] = index(values[i] - noise);
      high[i] = index(values[i] + noise);
    }
    for (std::int64_t a = low[0]; a <= high[0]; ++a) {
      for (std::int64_t b = low[1]; b <= high[1]; ++b) {
        for (std::int64_t c = low[2]; c <= high[2]; ++c) {
          for (std::int64_t d = low[3]; d <= high[3]; ++d) {
            const auto [begin, end] = in_cell_.equal_range(key(a, b, c, d));
            for (auto entry = begin; entry != end; ++entry) {
              if (holds(planes[entry->second], corners)) {
                return entry->second;
              }
            }
          }
        }
      }
    }
    return none;
  }

  bool holds(const Plane& plane, const std::array<glm::dvec3, 3>& corners) const {
    return std::ranges::all_of(corners, [&](const glm::dvec3& corner) {
      return std::abs(glm::dot(plane.normal, corner) - plane.offset) <= tolerance_;
    });
  }

  std::span<const glm::dvec3> positions_;
  std::span<const glm::uvec3> triangles_;
  double tolerance_;
  glm::dvec3 middle_{0.0};
  double size_ = 1.0;
  std::unordered_multimap<std::uint64_t, std::uint32_t> in_cell_;
};

std::vector<std::uint32_t> largest_first(std::span<const glm::dvec3> positions,
                                         std::span<const glm::uvec3> triangles) {
  std::vector<double> area(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const glm::uvec3& t = triangles[i];
    area[i] =
        glm::length(glm::cross(positions[t.y] - positions[t.x], positions[t.z] - positions[t.x]));
  }
  std::vector<std::uint32_t> order(triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order,
                           [&](std::uint32_t a, std::uint32_t b) { return area[a] > area[b]; });
  return order;
}

// The shared planes that a corner is on, at most three that cross at good angles. Those of larger
// triangles come first, so that the same corner of another operand is on the same ones.
struct OnPlanes {
  std::array<std::uint32_t, 3> plane{none, none, none};
  std::size_t count = 0;

  void add(std::uint32_t next, const std::vector<Plane>& planes) {
    const glm::dvec3& normal = planes[next].normal;
    if (count == 3 || std::find(plane.begin(), plane.end(), next) != plane.end()) {
      return;
    }
    if (count > 0) {
      const glm::dvec3 first = planes[plane[0]].normal;
      const glm::dvec3 side = count == 1 ? normal : glm::cross(first, planes[plane[1]].normal);
      const double crossing = count == 1 ? glm::length(glm::cross(first, normal))
                                         : std::abs(glm::dot(glm::normalize(side), normal));
      if (crossing < least_crossing) {
        return;
      }
    }
    plane[count++] = next;
  }
};

Exactly::Point_3 rational(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

class Mover {
 public:
  Mover(std::span<const glm::dvec3> positions, std::span<const glm::uvec3> triangles,
        const std::vector<Plane>& planes, double size)
      : positions_(positions),
        triangles_(triangles),
        planes_(planes),
        size_(size),
        known_(planes.size()) {}

  Exactly::Point_3 operator()(const glm::dvec3& position, const OnPlanes& on) {
    std::array<Exactly::Plane_3, 3> plane;
    const Exactly::Point_3 at = rational(position);
    plane[0] = exactly(on.plane[0]);
    if (on.count == 1) {
      return plane[0].projection(at);
    }
    plane[1] = exactly(on.plane[1]);
    const Exactly::Vector_3 along =
        CGAL::cross_product(plane[0].orthogonal_vector(), plane[1].orthogonal_vector());
    plane[2] = on.count == 3 ? exactly(on.plane[2]) : Exactly::Plane_3(at, along);
    return meeting(plane[0], plane[1], plane[2]);
  }

 private:
  const Exactly::Plane_3& exactly(std::uint32_t plane) {
    if (!known_[plane]) {
      known_[plane] =
          short_plane(planes_[plane].normal, positions_[triangles_[planes_[plane].triangle].x]);
    }
    return *known_[plane];
  }

  // A plane of few digits near the one through a point, since what is made of it has many. Across
  // an axis it goes through the point.
  Exactly::Plane_3 short_plane(const glm::dvec3& normal, const glm::dvec3& point) const {
    const glm::dvec3 whole = glm::round(normal * normal_steps);
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(whole[axis]) == normal_steps) {
        glm::dvec3 unit(0.0);
        unit[axis] = 1.0;
        return {unit.x, unit.y, unit.z, -point[axis]};
      }
    }
    const double step = std::exp2(std::floor(std::log2(size_))) * normal_steps / offset_steps;
    return {whole.x, whole.y, whole.z, -step * std::round(glm::dot(whole, point) / step)};
  }

  static Exactly::Point_3 meeting(const Exactly::Plane_3& a, const Exactly::Plane_3& b,
                                  const Exactly::Plane_3& c) {
    const auto bc = CGAL::cross_product(b.orthogonal_vector(), c.orthogonal_vector());
    const auto ca = CGAL::cross_product(c.orthogonal_vector(), a.orthogonal_vector());
    const auto ab = CGAL::cross_product(a.orthogonal_vector(), b.orthogonal_vector());
    const Exactly::FT volume = a.orthogonal_vector() * bc;
    return CGAL::ORIGIN - (bc * a.d() + ca * b.d() + ab * c.d()) / volume;
  }

  std::span<const glm::dvec3> positions_;
  std::span<const glm::uvec3> triangles_;
  const std::vector<Plane>& planes_;
  double size_;
  std::vector<std::optional<Exactly::Plane_3>> known_;
};

}  // namespace

std::vector<Exact::Point_3> onto_flush_planes(std::span<const glm::dvec3> positions,
                                              std::span<const glm::uvec3> triangles,
                                              const FlushTriangles& flush, double tolerance) {
  constexpr double farthest = 8.0;  // in tolerances
  Planes planes(positions, triangles, flush.spanning, 2.0 * tolerance);
  const std::vector<std::uint32_t> order = largest_first(positions, triangles);
  std::vector<std::uint32_t> plane_of(triangles.size());
  for (const std::uint32_t triangle : order) {
    const std::uint32_t surface = flush.surface[triangle];
    plane_of[triangle] = surface == none ? none
                         : flush.spanning[surface] != none
                             ? surface
                             : planes.add(triangle, flush.owner[triangle]);
  }
  // By plane, so that corners that are on the same planes take them in the same order.
  std::vector<std::uint32_t> by_plane = order;
  std::ranges::stable_sort(by_plane, {}, [&](std::uint32_t i) { return plane_of[i]; });
  std::vector<OnPlanes> on(positions.size());
  for (const std::uint32_t triangle : by_plane) {
    if (plane_of[triangle] == none || !planes.planes[plane_of[triangle]].shared) {
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      on[triangles[triangle][k]].add(plane_of[triangle], planes.planes);
    }
  }
  Mover moved(positions, triangles, planes.planes, planes.size());
  std::vector<Exact::Point_3> out;
  out.reserve(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (on[i].count > 0) {
      const Exactly::Point_3 to = moved(positions[i], on[i]);
      const Exact::Point_3 point(Exact::FT(to.x()), Exact::FT(to.y()), Exact::FT(to.z()));
      if (glm::distance(rounded(point), positions[i]) <= farthest * tolerance) {
        out.push_back(point);
        continue;
      }
    }
    out.push_back(exact(positions[i]));
  }
  return out;
}

}  // namespace raycat
