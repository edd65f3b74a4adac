#include "tracer/accel.hpp"

#include <array>
#include <cmath>
#include <new>
#include <stdexcept>
#include <utility>
#include <vector>

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/gtx/component_wise.hpp>

#include "geometry/line_clip.hpp"
#include "tracer/material_at.hpp"

namespace raycat {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double float_ulp = 0x1p-23;
constexpr double double_ulp = 0x1p-52;

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release>;
using EmbreeScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, Release>;

struct Triangle {
  glm::dvec3 a, b, c;
};

Triangle corners(const MeshInstance& instance, std::uint32_t triangle) {
  const TriangleMesh& mesh = instance.mesh->triangles;
  const glm::uvec3 i = mesh.triangles[triangle];
  return {.a = mesh.positions[i.x], .b = mesh.positions[i.y], .c = mesh.positions[i.z]};
}

// Does the ray meet the triangle from outside?
bool faces(const MeshInstance& instance, std::uint32_t triangle, const Ray& ray) {
  const Triangle local = corners(instance, triangle);
  const glm::dvec3 normal = glm::cross(local.b - local.a, local.c - local.a);
  return glm::dot(normal, instance.transform.to_local(ray).direction) < 0.0;
}

double greatest(const glm::dvec3& v) { return glm::compMax(glm::abs(v)); }

// One ray under way through Embree. The context comes first, so that callbacks find the rest.
struct Query {
  Query(const Ray& of, double end, Solid::Scratch& buffers)
      : ray(&of), t_end(end), scratch(&buffers) {}

  RTCIntersectContext context;
  const Ray* ray;
  double start = 0.0;  // where Embree's t = 0 is on the ray
  double t_end;
  Solid::Scratch* scratch;

  const SolidObject* solid = nullptr;  // the closest so far, and where it is met
  Boundary boundary;

  glm::vec3 light{1.0f};  // what has passed so far

  // What is absorbed on the way: the absorption of each stretch inside times its length. Boundaries
  // come in any order, so each adds its own part; `open` is what the ray ends inside of.
  glm::dvec3 depth{0.0};
  glm::dvec3 open{0.0};

  void cross(const glm::vec3& absorption, bool entering, double t) {
    const glm::dvec3 more = entering ? glm::dvec3(absorption) : -glm::dvec3(absorption);
    open += more;
    depth -= t * more;
  }

  // Where it has passed through meshes. Embree may report both triangles at an edge.
  struct Passage {
    unsigned mesh;
    float t;
  };
  std::array<Passage, 16> passages;  // the first `passage_count`; the rest is not even cleared
  std::size_t passage_count = 0;
};

Query& query_of(RTCIntersectContext* context) { return *reinterpret_cast<Query*>(context); }

// Keeps the solid's first boundary if it is closer than `query.t_end`, and tells whether it is.
bool try_closest(const SolidObject& object, Query& query) {
  const std::optional<Boundary> boundary =
      object.solid.first(*query.ray, 0.0, query.t_end, *query.scratch);
  if (!boundary) {
    return false;
  }
  query.solid = &object;
  query.boundary = *boundary;
  query.t_end = boundary->t;
  return true;
}

const Material& material_of(const Scene& scene, MaterialId id) {
  return scene.materials[static_cast<std::size_t>(id)];
}

// Weakens the light by the solid's boundaries before `query.t_end`; false if none is left.
bool let_through(const SolidObject& object, const Scene& scene, Query& query) {
  const Solid& solid = object.solid;
  for (auto met = solid.first(*query.ray, 0.0, query.t_end, *query.scratch); met;
       met = solid.next(*query.scratch)) {
    const Material& material = material_of(scene, object.materials[met->leaf]);
    query.light *= material.transmission;
    if (material.absorption != glm::vec3(0.0f)) {
      query.cross(material.absorption, met->entering, met->t);
    }
    if (query.light == glm::vec3(0.0f)) {
      return false;
    }
  }
  return true;
}

// What is left of light that has gone the whole way, beside what surfaces let through. A ray that
// starts inside of something is `open` by less than nothing, and has the way to its end counted.
glm::vec3 absorbed(const Query& query) {
  if (query.depth == glm::dvec3(0.0) && query.open == glm::dvec3(0.0)) {
    return glm::vec3(1.0f);
  }
  glm::dvec3 depth = query.depth;
  for (int c = 0; c < 3; ++c) {
    depth[c] += query.open[c] > 0.0 ? query.open[c] * query.t_end : 0.0;
  }
  return glm::vec3(glm::exp(-glm::max(depth, 0.0) * glm::length(query.ray->direction)));
}

}  // namespace

struct Accel::Index {
  explicit Index(const Scene& scene_in) : scene(scene_in) {}

  const Scene& scene;
  Device device{rtcNewDevice(nullptr)};
  EmbreeScene embree;
  glm::dvec3 centre{0.0};  // of Embree's frame in the world
  Bounds box;              // around all that Embree holds, with room for rounding
  double padding = 0.0;    // what rounding a ray to float may move it within the box
  std::vector<const SolidObject*> bounded;
  std::vector<const SolidObject*> unbounded;

  void place();
  void add_mesh(const MeshInstance& instance);
  void add_solids();
  bool start(const Ray& ray, Query& query, RTCRay& out) const;
  Hit mesh_hit(const Ray& ray, const RTCRayHit& found) const;
};

namespace {

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
  Query& query = query_of(args->context);
  if (*args->valid != 0 && try_closest(*index.bounded[args->primID], query)) {
    auto& found = *reinterpret_cast<RTCRayHit*>(args->rayhit);
    // Rounded up, so that what is closer than this by less than a float can tell is still tried.
    const float tfar = std::nextafter(static_cast<float>(query.t_end - query.start),
                                      std::numeric_limits<float>::infinity());
    if (tfar < found.ray.tfar) {  // else a triangle has been found in front of it
      found.ray.tfar = tfar;
      found.hit.geomID = args->geomID;
      found.hit.primID = args->primID;
    }
  }
}

void solid_occluded(const RTCOccludedFunctionNArguments* args) {
  const auto& index = *static_cast<const Accel::Index*>(args->geometryUserPtr);
  if (*args->valid != 0 &&
      !let_through(*index.bounded[args->primID], index.scene, query_of(args->context))) {
    reinterpret_cast<RTCRay*>(args->ray)->tfar = -std::numeric_limits<float>::infinity();
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

// Is this the first triangle reported of one passage through a mesh?
bool first_of_passage(const RTCFilterFunctionNArguments* args, Query& query) {
  const auto& index = *static_cast<const Accel::Index*>(args->geometryUserPtr);
  const unsigned mesh = reinterpret_cast<const RTCHit*>(args->hit)->geomID;
  const float t = reinterpret_cast<const RTCRay*>(args->ray)->tfar;
  const auto near = static_cast<float>(index.padding / glm::length(query.ray->direction));
  for (std::size_t i = 0; i < query.passage_count; ++i) {
    if (query.passages[i].mesh == mesh && std::abs(query.passages[i].t - t) <= near) {
      return false;
    }
  }
  if (query.passage_count < query.passages.size()) {
    query.passages[query.passage_count++] = {.mesh = mesh, .t = t};
  }
  return true;
}

void light_filter(const RTCFilterFunctionNArguments* args) {
  const Filtered met(args);
  Query& query = query_of(args->context);
  if (!met.masked() && first_of_passage(args, query)) {
    query.light *= transmission(met.index.scene, met.material, met.point, met.base);
    if (met.material.absorption != glm::vec3(0.0f)) {
      const float t = reinterpret_cast<const RTCRay*>(args->ray)->tfar;
      query.cross(met.material.absorption, faces(met.instance, met.hit.primID, *query.ray),
                  query.start + static_cast<double>(t));
    }
  }
  if (query.light != glm::vec3(0.0f)) {
    *args->valid = 0;
  }
}

}  // namespace

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
  if (material.alpha_cutoff > 0.0f) {
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

// Makes Embree's ray, from where `ray` enters the scene's box. False if it does not, or not
// before `query.t_end`.
bool Accel::Index::start(const Ray& ray, Query& query, RTCRay& out) const {
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
         .tfar = std::nextafter(tfar, std::numeric_limits<float>::infinity()),
         .mask = ~0u,
         .id = 0,
         .flags = 0};
  return true;
}

// Meets the triangle that Embree found again in double precision.
Hit Accel::Index::mesh_hit(const Ray& ray, const RTCRayHit& found) const {
  const MeshInstance& instance = scene.meshes[found.hit.geomID];
  const Triangle triangle = corners(instance, found.hit.primID);
  const Ray local = instance.transform.to_local(ray);
  const glm::dvec3 ab = triangle.b - triangle.a;
  const glm::dvec3 ac = triangle.c - triangle.a;
  const glm::dvec3 normal = glm::cross(ab, ac);
  const glm::dvec3 from = local.origin - triangle.a;
  const double facing = glm::dot(normal, local.direction);
  const double inverse = 1.0 / facing;
  const glm::dvec3 turn = glm::cross(from, local.direction);
  const glm::dvec2 barycentric(glm::clamp(glm::dot(ac, turn) * -inverse, 0.0, 1.0),
                               glm::clamp(glm::dot(ab, turn) * inverse, 0.0, 1.0));
  const MeshPoint point{
      .mesh = *instance.mesh, .triangle = found.hit.primID, .barycentric = barycentric};
  return {.t = -glm::dot(normal, from) / facing,
          .surface = SurfaceId{static_cast<std::uint32_t>(instance.first_face) + point.face()},
          .material = instance.material,
          .entering = facing < 0.0,
          .normal = instance.transform.normal(normal),
          .mesh = &instance,
          .triangle = found.hit.primID,
          .barycentric = barycentric};
}

Accel::Accel(const Scene& scene) : scene_(scene), index_(std::make_unique<Index>(scene)) {
  Index& index = *index_;
  if (!index.device) {
    throw std::runtime_error("Embree cannot start on this machine");
  }
  index.place();
  index.embree.reset(rtcNewScene(index.device.get()));
  rtcSetSceneFlags(index.embree.get(), RTC_SCENE_FLAG_ROBUST);
  for (const MeshInstance& instance : scene.meshes) {
    index.add_mesh(instance);
  }
  if (!index.bounded.empty()) {
    index.add_solids();
  }
  rtcCommitScene(index.embree.get());
  if (const RTCError error = rtcGetDeviceError(index.device.get()); error != RTC_ERROR_NONE) {
    throw std::runtime_error(
        error == RTC_ERROR_OUT_OF_MEMORY
            ? std::string("out of memory building the scene's BVH")
            : fmt::format("Embree failed with error {}", static_cast<int>(error)));
  }
}

Accel::~Accel() = default;

std::optional<Hit> Accel::closest(const Ray& ray, Solid::Scratch& scratch) const {
  Query query(ray, infinity, scratch);
  for (const SolidObject* object : index_->unbounded) {
    try_closest(*object, query);
  }
  RTCRayHit found;
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  if (index_->start(ray, query, found.ray)) {
    rtcInitIntersectContext(&query.context);
    rtcIntersect1(index_->embree.get(), &query.context, &found);
  }
  if (found.hit.geomID < scene_.meshes.size()) {
    std::optional<Hit> hit(index_->mesh_hit(ray, found));
    if (!std::isfinite(hit->t)) {  // a triangle seen edge-on
      hit->t = query.start + static_cast<double>(found.ray.tfar);
    }
    if (hit->t < query.t_end) {
      return hit;
    }
  }
  if (query.solid == nullptr) {
    return std::nullopt;
  }
  const Solid& solid = query.solid->solid;
  return Hit{.t = query.boundary.t,
             .surface = solid.surface(query.boundary),
             .material = query.solid->materials[query.boundary.leaf],
             .entering = query.boundary.entering,
             .normal = solid.normal(query.boundary)};
}

glm::vec3 Accel::transmittance(const Ray& ray, double t_end, Solid::Scratch& scratch) const {
  Query query(ray, t_end, scratch);
  for (const SolidObject* object : index_->unbounded) {
    if (!let_through(*object, scene_, query)) {
      return glm::vec3(0.0f);
    }
  }
  RTCRay shadow;
  if (index_->start(ray, query, shadow)) {
    rtcInitIntersectContext(&query.context);
    rtcOccluded1(index_->embree.get(), &query.context, &shadow);
    if (shadow.tfar < 0.0f) {
      return glm::vec3(0.0f);
    }
  }
  return query.light * absorbed(query);
}

glm::dvec3 Accel::leave(const Ray& ray, const Hit& hit, const glm::dvec3& normal) const {
  const glm::dvec3 point = ray.at(hit.t);
  if (hit.mesh == nullptr) {
    const double error = 0x1p20 * double_ulp * std::max(greatest(point), greatest(ray.origin));
    return point + error * normal;
  }
  const Triangle triangle = corners(*hit.mesh, hit.triangle);
  double scale = greatest(point - index_->centre);
  for (const glm::dvec3& corner : {triangle.a, triangle.b, triangle.c}) {
    scale = std::max(scale, greatest(hit.mesh->transform.point(corner) - index_->centre));
  }
  return point + 4 * float_ulp * scale * normal;
}

}  // namespace raycat
