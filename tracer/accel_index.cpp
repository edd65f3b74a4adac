#include "tracer/accel_index.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "geometry/line_clip.hpp"
#include "tracer/material_at.hpp"

namespace raycat {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

AccelQuery& query_of(RTCIntersectContext* context) {
  return *reinterpret_cast<AccelQuery*>(context);
}

// Does the ray meet the triangle from outside?
bool faces(const MeshInstance& instance, std::uint32_t triangle, const Ray& ray) {
  const TriangleCorners local = corners(instance, triangle);
  const glm::dvec3 normal = glm::cross(local.b - local.a, local.c - local.a);
  return glm::dot(normal, instance.transform.to_local(ray).direction) < 0.0;
}

void solid_bounds(const RTCBoundsFunctionArguments* args) {
  const auto& index = *static_cast<const Accel::Index*>(args->geometryUserPtr);
  const Bounds& box = index.bounded[args->primID]->solid.bounds();
  const glm::vec3 low(box.min - index.centre - index.padding);
  const glm::vec3 high(box.max - index.centre + index.padding);
  *args->bounds_o = {.lower_x = low.x,
                     .lower_y = low.y,
                     .lower_z = low.z,
                     .align0 = 0,
                     .upper_x = high.x,
                     .upper_y = high.y,
                     .upper_z = high.z,
                     .align1 = 0};
}

void solid_intersect(const RTCIntersectFunctionNArguments* args) {
  const auto& index = *static_cast<const Accel::Index*>(args->geometryUserPtr);
  AccelQuery& query = query_of(args->context);
  if (*args->valid != 0 && query.try_closest(*index.bounded[args->primID])) {
    auto& found = *reinterpret_cast<RTCRayHit*>(args->rayhit);
    // Rounded up, so that what is closer than this by less than a float can tell is still tried.
    const float tfar = std::nextafter(static_cast<float>(query.t_end - query.start), infinity);
    if (tfar < found.ray.tfar) {  // else a triangle has been found in front of it
      found.ray.tfar = tfar;
      found.hit.geomID = args->geomID;
      found.hit.primID = args->primID;
    }
  }
}

void solid_occluded(const RTCOccludedFunctionNArguments* args) {
  const auto& index = *static_cast<const Accel::Index*>(args->geometryUserPtr);
  AccelQuery& query = query_of(args->context);
  if (*args->valid != 0 &&
      !query.light->through(*index.bounded[args->primID], index.scene, query.scratch)) {
    reinterpret_cast<RTCRay*>(args->ray)->tfar = -infinity;
  }
}

// The triangle that a filter is asked about.
struct Filtered {
  explicit Filtered(const RTCFilterFunctionNArguments* args)
      : index(*static_cast<const Accel::Index*>(args->geometryUserPtr)),
        hit(*reinterpret_cast<const RTCHit*>(args->hit)),
        instance(index.scene.meshes[hit.geomID]),
        material(material_of(index.scene, instance.material)),
        point{.mesh = *instance.mesh, .triangle = hit.primID, .barycentric = {hit.u, hit.v}},
        base(base_colour(index.scene, material, point)) {}

  bool masked() const { return material.alpha * base.a < material.alpha_cutoff; }

  const Accel::Index& index;
  const RTCHit& hit;
  const MeshInstance& instance;
  const Material& material;
  MeshPoint point;
  glm::vec4 base;
};

void mask_filter(const RTCFilterFunctionNArguments* args) {
  if (Filtered(args).masked()) {
    *args->valid = 0;
  }
}

// Of single-sided materials, masked or not.
void back_face_filter(const RTCFilterFunctionNArguments* args) {
  const auto& index = *static_cast<const Accel::Index*>(args->geometryUserPtr);
  const auto& hit = *reinterpret_cast<const RTCHit*>(args->hit);
  const MeshInstance& instance = index.scene.meshes[hit.geomID];
  if (!faces(instance, hit.primID, query_of(args->context).ray)) {
    *args->valid = 0;
  } else if (material_of(index.scene, instance.material).alpha_cutoff > 0.0f) {
    mask_filter(args);
  }
}

void light_filter(const RTCFilterFunctionNArguments* args) {
  const Filtered met(args);
  AccelQuery& query = query_of(args->context);
  const float t = reinterpret_cast<const RTCRay*>(args->ray)->tfar;
  const auto near = static_cast<float>(met.index.padding / glm::length(query.ray.direction));
  if (!met.masked() && query.light->first_of_passage(met.hit.geomID, t, near)) {
    query.light->through(transmission(met.index.scene, met.material, met.point, met.base),
                         met.material.absorption, faces(met.instance, met.hit.primID, query.ray),
                         query.start + static_cast<double>(t));
  }
  if (!query.light->stopped()) {
    *args->valid = 0;
  }
}

}  // namespace

bool AccelQuery::try_closest(const SolidObject& object) {
  const std::optional<Boundary> met = object.solid.first(ray, 0.0, t_end, scratch);
  if (!met) {
    return false;
  }
  solid = &object;
  boundary = *met;
  t_end = met->t;
  return true;
}

TriangleCorners corners(const MeshInstance& instance, std::uint32_t triangle) {
  const TriangleMesh& mesh = instance.mesh->triangles;
  const glm::uvec3 i = mesh.triangles[triangle];
  return {.a = mesh.positions[i.x], .b = mesh.positions[i.y], .c = mesh.positions[i.z]};
}

Accel::Index::Index(const Scene& scene_in) : scene(scene_in) {
  if (!device) {
    throw std::runtime_error("Embree cannot start on this machine");
  }
  place();
  embree.reset(rtcNewScene(device.get()));
  rtcSetSceneFlags(embree.get(), RTC_SCENE_FLAG_ROBUST);
  for (const MeshInstance& instance : scene.meshes) {
    add_mesh(instance);
  }
  if (!bounded.empty()) {
    add_solids();
  }
  rtcCommitScene(embree.get());
  if (const RTCError error = rtcGetDeviceError(device.get()); error != RTC_ERROR_NONE) {
    throw std::runtime_error(
        error == RTC_ERROR_OUT_OF_MEMORY
            ? std::string("out of memory building the scene's BVH")
            : fmt::format("Embree failed with error {}", static_cast<int>(error)));
  }
}

// Embree works in float around the middle of the scene, where floats are finest.
void Accel::Index::place() {
  for (const SolidObject& object : scene.solids) {
    const Bounds& solid = object.solid.bounds();
    if (solid.empty()) {
      continue;
    }
    (solid.finite() ? bounded : unbounded).push_back(&object);
    if (solid.finite()) {
      box.include(solid);
    }
  }
  for (const MeshInstance& instance : scene.meshes) {
    box.include(instance.transform.bounds(raycat::bounds(instance.mesh->triangles)));
  }
  if (!box.empty()) {
    centre = box.center();
    padding = 8 * float_ulp * greatest(box.half_size());
    box.min -= padding;
    box.max += padding;
  }
  // Past a fifth of a float's range Embree takes a coordinate for infinite.
  if (!box.empty() && !(greatest(box.half_size()) < 1e18)) {
    throw std::length_error("a scene spans at most 1e18 units");
  }
}

void Accel::Index::add_mesh(const MeshInstance& instance) {
  const TriangleMesh& mesh = instance.mesh->triangles;
  RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               mesh.positions.size()));
  for (const glm::dvec3& position : mesh.positions) {
    const glm::vec3 p(instance.transform.point(position) - centre);
    *vertices++ = p.x;
    *vertices++ = p.y;
    *vertices++ = p.z;
  }
  static_assert(sizeof(glm::uvec3) == 3 * sizeof(unsigned));
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh.triangles.data(), 0, sizeof(glm::uvec3), mesh.triangles.size());
  rtcSetGeometryUserData(geometry, this);
  const Material& material = material_of(scene, instance.material);
  if (material.single_sided) {
    rtcSetGeometryIntersectFilterFunction(geometry, back_face_filter);
  } else if (material.alpha_cutoff > 0.0f) {
    rtcSetGeometryIntersectFilterFunction(geometry, mask_filter);
  }
  if (material.alpha_cutoff > 0.0f || material.blend || material.transmission != glm::vec3(0.0f)) {
    rtcSetGeometryOccludedFilterFunction(geometry, light_filter);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(embree.get(), geometry);
  rtcReleaseGeometry(geometry);
}

void Accel::Index::add_solids() {
  RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(bounded.size()));
  rtcSetGeometryUserData(geometry, this);
  rtcSetGeometryBoundsFunction(geometry, solid_bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, solid_intersect);
  rtcSetGeometryOccludedFunction(geometry, solid_occluded);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(embree.get(), geometry);
  rtcReleaseGeometry(geometry);
}

bool Accel::Index::start(const Ray& ray, AccelQuery& query, RTCRay& out) const {
  const Interval inside = LineClip(ray)(box, {.begin = 0.0, .end = query.t_end});
  if (inside.empty()) {
    return false;
  }
  const double near = inside.begin;
  query.start = near;
  const glm::vec3 origin(ray.at(near) - centre);
  const glm::vec3 direction(ray.direction);
  const auto tfar = static_cast<float>(query.t_end - near);
  out = {.org_x = origin.x,
         .org_y = origin.y,
         .org_z = origin.z,
         .tnear = 0.0f,
         .dir_x = direction.x,
         .dir_y = direction.y,
         .dir_z = direction.z,
         .time = 0.0f,
         .tfar = std::nextafter(tfar, infinity),
         .mask = ~0u,
         .id = 0,
         .flags = 0};
  return true;
}

}  // namespace raycat
