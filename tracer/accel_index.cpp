#include "tracer/accel_index.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "geometry/line_clip.hpp"
#include "tracer/accel_query.hpp"

namespace raycat {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr double double_ulp = 0x1p-52;

// A mesh that spans fewer of its coordinates' float errors than this is met in double alone.
constexpr double fewest_steps = 4096.0;

// Within so many of Embree's errors of its start, a ray is told apart from what it starts on.
constexpr double near_paddings = 64.0;

AccelQuery& query_of(RTCIntersectContext* context) {
  return *reinterpret_cast<AccelQuery*>(context);
}

const Accel::Index& index_of(void* user) { return *static_cast<const Accel::Index*>(user); }

void set_bounds(const Accel::Index& index, const Bounds& box, RTCBounds& out) {
  const glm::vec3 low(box.min - index.centre - index.padding);
  const glm::vec3 high(box.max - index.centre + index.padding);
  out = {.lower_x = low.x,
         .lower_y = low.y,
         .lower_z = low.z,
         .align0 = 0,
         .upper_x = high.x,
         .upper_y = high.y,
         .upper_z = high.z,
         .align1 = 0};
}

// Embree's ray ends where the query is done; what is hit, the query knows.
void found_first(const RTCIntersectFunctionNArguments* args, const AccelQuery& query) {
  auto& found = *reinterpret_cast<RTCRayHit*>(args->rayhit);
  found.ray.tfar = std::min(found.ray.tfar, query.reach());
  found.hit.geomID = args->geomID;
  found.hit.primID = args->primID;
}

void stop(const RTCOccludedFunctionNArguments* args) {
  reinterpret_cast<RTCRay*>(args->ray)->tfar = -infinity;
}

void solid_bounds(const RTCBoundsFunctionArguments* args) {
  const Accel::Index& index = index_of(args->geometryUserPtr);
  set_bounds(index, index.bounded[args->primID]->solid.bounds(), *args->bounds_o);
}

void solid_intersect(const RTCIntersectFunctionNArguments* args) {
  AccelQuery& query = query_of(args->context);
  if (*args->valid != 0 && query.offer(*index_of(args->geometryUserPtr).bounded[args->primID])) {
    found_first(args, query);
  }
}

void solid_occluded(const RTCOccludedFunctionNArguments* args) {
  AccelQuery& query = query_of(args->context);
  if (*args->valid != 0 &&
      !query.shade(*index_of(args->geometryUserPtr).bounded[args->primID], *query.light)) {
    stop(args);
  }
}

// Calls `seen(met)` for what the ray meets of a mesh that Embree does not see, until it is false.
template <typename Seen>
void pass(const Accel::Index::SmallMesh& mesh, const Ray& ray, const Seen& seen) {
  thread_local TriangleIndex::Passages passages;
  mesh.triangles->pass(mesh.instance->transform.to_local(ray), passages);
  for (const TriangleIndex::Passage& passage : passages.list) {
    const std::optional<TriangleMet> met = meet(*mesh.instance, passage.triangle, ray);
    if (met && !seen(*met)) {
      return;
    }
  }
}

void small_mesh_bounds(const RTCBoundsFunctionArguments* args) {
  const Accel::Index& index = index_of(args->geometryUserPtr);
  const MeshInstance* instance = index.small_meshes[args->primID].instance;
  set_bounds(index,
             index.mesh_bounds[static_cast<std::size_t>(instance - index.scene.meshes.data())],
             *args->bounds_o);
}

void small_mesh_intersect(const RTCIntersectFunctionNArguments* args) {
  AccelQuery& query = query_of(args->context);
  if (*args->valid == 0) {
    return;
  }
  bool found = false;
  pass(index_of(args->geometryUserPtr).small_meshes[args->primID], query.ray(),
       [&](const TriangleMet& met) {
         found = query.offer(met) || found;
         return true;
       });
  if (found) {
    found_first(args, query);
  }
}

void small_mesh_occluded(const RTCOccludedFunctionNArguments* args) {
  AccelQuery& query = query_of(args->context);
  if (*args->valid == 0) {
    return;
  }
  pass(index_of(args->geometryUserPtr).small_meshes[args->primID], query.ray(),
       [&](const TriangleMet& met) { return query.shade(met, *query.light, 0.0); });
  if (query.light->stopped()) {
    stop(args);
  }
}

// What Embree has found when it calls a filter; none if it is what the ray starts on.
std::optional<FloatMet> filtered(const RTCFilterFunctionNArguments* args, const AccelQuery& query) {
  const auto& hit = *reinterpret_cast<const RTCHit*>(args->hit);
  const MeshInstance& instance = index_of(args->geometryUserPtr).scene.meshes[hit.geomID];
  if (query.leaves(&instance, hit.primID)) {
    return std::nullopt;
  }
  const glm::vec3 normal(hit.Ng_x, hit.Ng_y, hit.Ng_z);
  const float gained = glm::dot(normal, glm::vec3(query.ray().direction));
  return FloatMet{.instance = &instance,
                  .triangle = hit.primID,
                  .t = query.embree_start +
                       static_cast<double>(reinterpret_cast<const RTCRay*>(args->ray)->tfar),
                  .rise = static_cast<double>(std::abs(gained) / glm::length(normal)),
                  .entering = (gained < 0.0f) != instance.transform.mirrored()};
}

void first_filter(const RTCFilterFunctionNArguments* args) {
  AccelQuery& query = query_of(args->context);
  const std::optional<FloatMet> met = filtered(args, query);
  if (met && query.offer(*met)) {
    reinterpret_cast<RTCRay*>(args->ray)->tfar = query.reach();
  } else {
    *args->valid = 0;
  }
}

void light_filter(const RTCFilterFunctionNArguments* args) {
  AccelQuery& query = query_of(args->context);
  const double near = index_of(args->geometryUserPtr).padding / glm::length(query.ray().direction);
  const std::optional<FloatMet> met = filtered(args, query);
  if (!met || query.shade(*met, *query.light, near)) {
    *args->valid = 0;
  }
}

}  // namespace

TriangleCorners corners(const MeshInstance& instance, std::uint32_t triangle) {
  const TriangleMesh& mesh = instance.mesh->triangles;
  const glm::uvec3 i = mesh.triangles[triangle];
  return {.a = mesh.positions[i.x], .b = mesh.positions[i.y], .c = mesh.positions[i.z]};
}

Accel::Index::Index(const Scene& scene_in) : scene(scene_in), layers(scene_in) {
  if (!device) {
    throw std::runtime_error("Embree cannot start on this machine");
  }
  place_frame();
  embree.reset(rtcNewScene(device.get()));
  rtcSetSceneFlags(embree.get(), RTC_SCENE_FLAG_ROBUST);
  add_meshes();
  if (!bounded.empty()) {
    add_user_geometry(bounded.size(), solid_bounds, solid_intersect, solid_occluded);
  }
  if (!small_meshes.empty()) {
    add_user_geometry(small_meshes.size(), small_mesh_bounds, small_mesh_intersect,
                      small_mesh_occluded);
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
void Accel::Index::place_frame() {
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
    mesh_bounds.push_back(instance.transform.bounds(raycat::bounds(instance.mesh->triangles)));
    box.include(mesh_bounds.back());
  }
  if (!box.empty()) {
    centre = box.center();
    padding = 8 * float_ulp * greatest(box.half_size());
    farthest = std::max(greatest(box.min), greatest(box.max));
    near2 = std::pow(near_paddings * padding, 2.0);
    box.min -= padding;
    box.max += padding;
  }
  // Past a fifth of a float's range Embree takes a coordinate for infinite.
  if (!box.empty() && !(greatest(box.half_size()) < 1e18)) {
    throw std::length_error("a scene spans at most 1e18 units");
  }
}

void Accel::Index::add_meshes() {
  needs_double.resize(scene.meshes.size());
  std::map<const SurfaceMesh*, std::shared_ptr<const TriangleIndex>> shared;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const MeshInstance& instance = scene.meshes[i];
    const Bounds& around = mesh_bounds[i];
    const double error = float_ulp * std::max(greatest(around.min - centre),  //
                                              greatest(around.max - centre));
    if (2.0 * greatest(around.half_size()) >= fewest_steps * error) {
      const bool needs = material_of(scene, instance.material).alpha_cutoff > 0.0f ||
                         !instance.mesh->twins.empty() || layers.any_of_mesh(i);
      needs_double[i] = needs ? 1 : 0;
      add_mesh(i, instance);
      continue;
    }
    std::shared_ptr<const TriangleIndex>& triangles = shared[instance.mesh.get()];
    if (!triangles) {
      triangles = std::make_shared<const TriangleIndex>(instance.mesh->triangles);
    }
    small_meshes.push_back({.instance = &instance, .triangles = triangles});
  }
}

void Accel::Index::add_mesh(std::size_t number, const MeshInstance& instance) {
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
  rtcSetGeometryIntersectFilterFunction(geometry, first_filter);
  rtcSetGeometryOccludedFilterFunction(geometry, light_filter);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(embree.get(), geometry, static_cast<unsigned>(number));
  rtcReleaseGeometry(geometry);
}

void Accel::Index::add_user_geometry(std::size_t count, RTCBoundsFunction bounds,
                                     RTCIntersectFunctionN intersect,
                                     RTCOccludedFunctionN occluded) {
  RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(count));
  rtcSetGeometryUserData(geometry, this);
  rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect);
  rtcSetGeometryOccludedFunction(geometry, occluded);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(embree.get(), geometry);
  rtcReleaseGeometry(geometry);
}

bool Accel::Index::start(AccelQuery& query, RTCRay& out) const {
  const Ray& ray = query.ray();
  // From a little before, so that what is wrong in float hides nothing that the ray starts at.
  const double before = query.begin - 4.0 * float_error(ray.origin) / greatest(ray.direction);
  const Interval inside = LineClip(ray)(box, {.begin = before, .end = query.t_end()});
  if (inside.empty()) {
    return false;
  }
  query.embree_start = inside.begin;
  const glm::vec3 origin(ray.at(inside.begin) - centre);
  const glm::vec3 direction(ray.direction);
  out = {.org_x = origin.x,
         .org_y = origin.y,
         .org_z = origin.z,
         .tnear = 0.0f,
         .dir_x = direction.x,
         .dir_y = direction.y,
         .dir_z = direction.z,
         .time = 0.0f,
         .tfar = query.reach(),
         .mask = ~0u,
         .id = 0,
         .flags = 0};
  return true;
}

double Accel::Index::on_surface(const glm::dvec3& origin) const {
  return 0x1p8 * double_ulp * std::max(greatest(origin), farthest);
}

double Accel::Index::leave_distance(const glm::dvec3& origin, const glm::dvec3& point,
                                    bool of_triangle) const {
  // Planes are met to some of the last digits, a torus is not.
  const double least =
      0x1p10 * double_ulp * std::max({greatest(point), greatest(origin), farthest});
  return of_triangle
             ? least
             : std::max(0x1p20 * double_ulp * std::max(greatest(point), greatest(origin)), least);
}

}  // namespace raycat
