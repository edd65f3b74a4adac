#include "tracer/accel.hpp"

#include <cmath>

#include <glm/geometric.hpp>

#include "tracer/accel_index.hpp"

namespace raycat {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double double_ulp = 0x1p-52;

// Meets the triangle that Embree found again in double precision.
Hit mesh_hit(const Scene& scene, const Ray& ray, const RTCRayHit& found) {
  const MeshInstance& instance = scene.meshes[found.hit.geomID];
  const TriangleCorners triangle = corners(instance, found.hit.primID);
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

}  // namespace

Accel::Accel(const Scene& scene) : scene_(scene), index_(std::make_unique<Index>(scene)) {}

Accel::~Accel() = default;

std::optional<Hit> Accel::closest(const Ray& ray, Solid::Scratch& scratch) const {
  AccelQuery query(ray, infinity, scratch);
  for (const SolidObject* object : index_->unbounded) {
    query.try_closest(*object);
  }
  RTCRayHit found;
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  if (index_->start(ray, query, found.ray)) {
    rtcInitIntersectContext(&query.context);
    rtcIntersect1(index_->embree.get(), &query.context, &found);
  }
  if (found.hit.geomID < scene_.meshes.size()) {
    std::optional<Hit> hit(mesh_hit(scene_, ray, found));
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
  LightPassage light(ray, t_end);
  for (const SolidObject* object : index_->unbounded) {
    if (!light.through(*object, scene_, scratch)) {
      return glm::vec3(0.0f);
    }
  }
  AccelQuery query(ray, t_end, scratch);
  query.light = &light;
  RTCRay shadow;
  if (index_->start(ray, query, shadow)) {
    rtcInitIntersectContext(&query.context);
    rtcOccluded1(index_->embree.get(), &query.context, &shadow);
    if (shadow.tfar < 0.0f) {
      return glm::vec3(0.0f);
    }
  }
  return light.left();
}

glm::dvec3 Accel::leave(const Ray& ray, const Hit& hit, const glm::dvec3& normal) const {
  const glm::dvec3 point = ray.at(hit.t);
  if (hit.mesh == nullptr) {
    const double error = 0x1p20 * double_ulp * std::max(greatest(point), greatest(ray.origin));
    return point + error * normal;
  }
  const TriangleCorners triangle = corners(*hit.mesh, hit.triangle);
  double scale = greatest(point - index_->centre);
  for (const glm::dvec3& corner : {triangle.a, triangle.b, triangle.c}) {
    scale = std::max(scale, greatest(hit.mesh->transform.point(corner) - index_->centre));
  }
  return point + 4 * float_ulp * scale * normal;
}

}  // namespace raycat
