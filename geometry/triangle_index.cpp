#include "geometry/triangle_index.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "geometry/line_clip.hpp"
#include "geometry/line_view.hpp"

namespace raycat {
namespace {

using Passage = TriangleIndex::Passage;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Up to here, testing every triangle is faster than asking Embree for the right ones.
constexpr std::size_t most_unindexed = 32;

// Wider by what rounding can do to a line that touches it.
Bounds widened(Bounds box) {
  const glm::dvec3 margin =
      8.0 * epsilon * (glm::max(glm::abs(box.min), glm::abs(box.max)) + 2.0 * box.half_size());
  box.min -= margin;
  box.max += margin;
  return box;
}

void pass_through(const LineView& view, const glm::dvec3& a, const glm::dvec3& b,
                  const glm::dvec3& c, std::uint32_t triangle, std::vector<Passage>& out) {
  const int side = side_of_line(a, b);
  if (side == 0 || side_of_line(b, c) != side || side_of_line(c, a) != side) {
    return;
  }
  // The areas have one sign, or are zero, so that this never leaves the triangle's own extent,
  // however the line grazes it; and it is exact for a triangle square to the line. Their sum is
  // not zero: if the triangle were seen edge-on, the sides would differ.
  const double at_a = std::abs(area_at_line(b, c));
  const double at_b = std::abs(area_at_line(c, a));
  const double at_c = std::abs(area_at_line(a, b));
  const double area = at_a + at_b + at_c;
  const double z = a.z + (b.z - a.z) * (at_b / area) + (c.z - a.z) * (at_c / area);
  out.push_back({.t = view.parameter(z), .area = area, .triangle = triangle, .turn = -side});
}

RTCDevice device() {
  struct Device {
    // One thread: Embree's own are uninstrumented, and the thread sanitizer takes them for races.
    RTCDevice handle = rtcNewDevice("threads=1");
    Device() {
      if (handle == nullptr) {
        throw std::runtime_error(fmt::format("Embree does not start: error {}",
                                             static_cast<int>(rtcGetDeviceError(nullptr))));
      }
    }
    ~Device() { rtcReleaseDevice(handle); }
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
  };
  static const Device shared;
  return shared.handle;
}

}  // namespace

// Finds, in single precision, all triangles that the line may pass: Embree's boxes are wider
// than its rounding errors, and the exact test is ours. Embree sees the mesh about the origin
// and at most 1 from it, so that neither its place nor its size costs precision.
struct TriangleIndex::Tree {
  explicit Tree(const TriangleMesh& indexed, const Bounds& box)
      : mesh(indexed),
        center(box.center()),
        scale(std::max({box.half_size().x, box.half_size().y, box.half_size().z})),
        scene(rtcNewScene(device())) {
    RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(mesh.triangles.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, triangle_bounds, nullptr);
    rtcSetGeometryOccludedFunction(geometry, test_triangle);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    if (const RTCError error = rtcGetDeviceError(device()); error != RTC_ERROR_NONE) {
      rtcReleaseScene(scene);
      throw std::runtime_error(fmt::format("Embree cannot index a mesh of {} triangles: error {}",
                                           mesh.triangles.size(), static_cast<int>(error)));
    }
  }
  ~Tree() { rtcReleaseScene(scene); }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  /// `origin` is in the mesh's bounds.
  void collect(const LineView& view, const glm::dvec3& origin, const glm::dvec3& direction,
               std::vector<Passage>& out) const {
    Query query;
    rtcInitIntersectContext(&query);
    query.view = &view;
    query.out = &out;
    // Along the axis that it follows most, the line is outside the box after 2; Embree ignores
    // what lies behind the start.
    const glm::dvec3 size = glm::abs(direction);
    const glm::dvec3 step = direction / std::max({size.x, size.y, size.z});
    const glm::vec3 start((origin - center) / scale - 2.5 * step);
    const glm::vec3 along(step);
    RTCRay ray{};
    ray.org_x = start.x;
    ray.org_y = start.y;
    ray.org_z = start.z;
    ray.dir_x = along.x;
    ray.dir_y = along.y;
    ray.dir_z = along.z;
    ray.tfar = std::numeric_limits<float>::infinity();
    ray.mask = ~0U;
    rtcOccluded1(scene, &query, &ray);
  }

 private:
  struct Query : RTCIntersectContext {
    const LineView* view;
    std::vector<Passage>* out;
  };

  static void triangle_bounds(const RTCBoundsFunctionArguments* args) {
    // Starts are within 3.5 and points within 1: 4 * 2^-23 * 4.5, and as much again.
    constexpr double margin = 4.4e-6;
    const auto& tree = *static_cast<const Tree*>(args->geometryUserPtr);
    const glm::uvec3& triangle = tree.mesh.triangles[args->primID];
    Bounds box;
    for (int k = 0; k < 3; ++k) {
      box.include((tree.mesh.positions[triangle[k]] - tree.center) / tree.scale);
    }
    const glm::vec3 low(box.min - margin);
    const glm::vec3 high(box.max + margin);
    *args->bounds_o = {.lower_x = low.x,
                       .lower_y = low.y,
                       .lower_z = low.z,
                       .align0 = 0.0F,
                       .upper_x = high.x,
                       .upper_y = high.y,
                       .upper_z = high.z,
                       .align1 = 0.0F};
  }

  // Reports no hit to Embree, which therefore goes on to the next triangle.
  static void test_triangle(const RTCOccludedFunctionNArguments* args) {
    const auto& mesh = static_cast<const Tree*>(args->geometryUserPtr)->mesh;
    const auto& query = *static_cast<const Query*>(args->context);
    const glm::uvec3& triangle = mesh.triangles[args->primID];
    pass_through(*query.view, (*query.view)(mesh.positions[triangle.x]),
                 (*query.view)(mesh.positions[triangle.y]),
                 (*query.view)(mesh.positions[triangle.z]), args->primID, *query.out);
  }

  // Public, though the struct itself is not.  NOLINTBEGIN(readability-identifier-naming)
  const TriangleMesh& mesh;
  glm::dvec3 center;
  double scale;
  RTCScene scene;
  // NOLINTEND(readability-identifier-naming)
};

TriangleIndex::TriangleIndex(const TriangleMesh& mesh)
    : mesh_(mesh), bounds_(raycat::bounds(mesh)) {
  if (mesh_.triangles.size() > most_unindexed) {
    tree_ = std::make_unique<Tree>(mesh_, bounds_);
  }
}

TriangleIndex::~TriangleIndex() = default;

void TriangleIndex::pass(const Ray& ray, Passages& out) const {
  out.list.clear();
  const Bounds box = widened(bounds_);
  Interval inside = LineClip(ray)(box);
  if (inside.empty()) {
    return;
  }
  // A far origin would cost the view its precision, so the view starts at the point of the box
  // that is next to it. With a fused multiplication that point is on the line to its last bit.
  out.near = ray;
  out.t_shift = std::clamp(0.0, inside.begin, inside.end);
  if (out.t_shift != 0.0) {
    for (int k = 0; k < 3; ++k) {
      out.near.origin[k] = std::fma(out.t_shift, ray.direction[k], ray.origin[k]);
    }
    inside = LineClip(out.near)(box);
    if (inside.empty()) {
      return;
    }
  }
  const double reach = std::max(std::abs(inside.begin), std::abs(inside.end));
  out.tolerance = epsilon * (16.0 * reach + 2.0 * std::abs(out.t_shift));

  const LineView view(out.near.origin, out.near.direction);
  if (tree_ != nullptr) {
    tree_->collect(view, out.near.origin, out.near.direction, out.list);
  } else {
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const glm::uvec3& triangle = mesh_.triangles[i];
      pass_through(view, view(mesh_.positions[triangle.x]), view(mesh_.positions[triangle.y]),
                   view(mesh_.positions[triangle.z]), static_cast<std::uint32_t>(i), out.list);
    }
  }
  std::sort(out.list.begin(), out.list.end(), [](const Passage& a, const Passage& b) {
    return a.t != b.t ? a.t < b.t : a.triangle < b.triangle;
  });
}

void TriangleIndex::cross(const Ray& ray, Crossings& out) const {
  thread_local Passages passages;
  pass(ray, passages);
  for (const Passage& passage : passages.list) {
    out.push_back({.t = passages.t_shift + passage.t,
                   .normal = outward_normal(passage, ray.direction),
                   .face = mesh_.faces[passage.triangle],
                   .piece = passage.triangle,
                   .entering = passage.turn > 0});
  }
}

glm::dvec3 TriangleIndex::outward_normal(const Passage& passage,
                                         const glm::dvec3& direction) const {
  const glm::uvec3& triangle = mesh_.triangles[passage.triangle];
  const glm::dvec3& a = mesh_.positions[triangle.x];
  const glm::dvec3 normal =
      glm::cross(mesh_.positions[triangle.y] - a, mesh_.positions[triangle.z] - a);
  // A sliver's own normal is noise, which may even contradict the exact predicate.
  const glm::dvec3 backwards = passage.turn > 0 ? -direction : direction;
  return glm::dot(normal, backwards) > 0.0 ? normal : backwards;
}

}  // namespace raycat
