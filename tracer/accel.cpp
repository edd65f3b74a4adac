#include "tracer/accel.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "tracer/accel_index.hpp"
#include "tracer/accel_query.hpp"

namespace raycat {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

Accel::Accel(const Scene& scene) : scene_(scene), index_(std::make_unique<Index>(scene)) {}

Accel::~Accel() = default;

std::optional<Hit> Accel::closest(const Ray& ray, Solid::Scratch& scratch,
                                  const Departure& from) const {
  AccelQuery query(*index_, ray, from, infinity, scratch);
  for (const SolidObject* object : index_->unbounded) {
    query.offer(*object);
  }
  RTCRayHit found;
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  if (index_->start(query, found.ray)) {
    rtcInitIntersectContext(&query.context);
    rtcIntersect1(index_->embree.get(), &query.context, &found);
  }
  return query.first();
}

glm::vec3 Accel::transmittance(const Ray& ray, double t_end, Solid::Scratch& scratch,
                               const Departure& from) const {
  LightPassage light(ray, t_end);
  AccelQuery query(*index_, ray, from, t_end, scratch);
  for (const SolidObject* object : index_->unbounded) {
    if (!query.shade(*object, light)) {
      return glm::vec3(0.0f);
    }
  }
  query.light = &light;
  RTCRay shadow;
  if (index_->start(query, shadow)) {
    rtcInitIntersectContext(&query.context);
    rtcOccluded1(index_->embree.get(), &query.context, &shadow);
  }
  return light.stopped() ? glm::vec3(0.0f) : light.left();
}

std::optional<Hit> Accel::next_at(const Ray& ray, const Hit& hit, Solid::Scratch& scratch) const {
  if (!hit.layer.shared()) {
    return std::nullopt;
  }
  const Departure from = departure(ray, hit, ray.direction);
  const Ray on{.origin = ray.at(hit.t), .direction = ray.direction};
  std::optional<Hit> next = closest(on, scratch, from);
  if (!next || next->layer.surface != hit.layer.surface || std::abs(next->t) > from.behind) {
    return std::nullopt;
  }
  next->t += hit.t;
  return next;
}

glm::dvec3 Accel::leave(const Ray& ray, const Hit& hit, const glm::dvec3& normal) const {
  const glm::dvec3 point = ray.at(hit.t);
  return point + index_->leave_distance(ray.origin, point, hit.mesh != nullptr) * normal;
}

Departure Accel::departure(const Ray& ray, const Hit& hit, const glm::dvec3& direction) const {
  Departure from{.mesh = hit.mesh, .triangle = hit.triangle, .layer = hit.layer};
  if (hit.layer.shared()) {
    const double outwards = glm::dot(hit.normal, direction);
    from.along = hit.layer.along(outwards < 0.0);
    from.reach = index_->layers.place(hit.layer) +
                 2.0 * index_->leave_distance(ray.origin, ray.at(hit.t), hit.mesh != nullptr);
    from.behind = from.reach / std::abs(outwards);
  }
  return from;
}

}  // namespace raycat
