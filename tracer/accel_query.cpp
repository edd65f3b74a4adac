#include "tracer/accel_query.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "geometry/coincident_twins.hpp"
#include "tracer/accel_index.hpp"
#include "tracer/material_at.hpp"

namespace raycat {
namespace {

constexpr auto float_ulp_up = static_cast<float>(float_ulp);

// By which a point may lie outside of a triangle, of barycentric coordinates' rounding.
constexpr double outside = 1e-12;

// Within so many of Embree's errors, a triangle may be met that lies beside the ray.
constexpr double near_errors = 64.0;

// Of rays and planes: at less, double precision tells which side is met.
constexpr double least_slope = 1e-3;

bool masked(const Material& material, const glm::vec4& base) {
  return material.alpha_cutoff > 0.0f && material.alpha * base.a < material.alpha_cutoff;
}

// Everywhere?
bool opaque(const Material& material) {
  return !material.blend && material.transmission == glm::vec3(0.0f) &&
         material.alpha_cutoff <= 0.0f;
}

// As `meet`, of one triangle alone.
std::optional<TriangleMet> meet_plane(const MeshInstance& instance, std::uint32_t triangle,
                                      const Ray& ray) {
  const TriangleCorners corner = corners(instance, triangle);
  const Ray local = instance.transform.to_local(ray);
  const glm::dvec3 ab = corner.b - corner.a;
  const glm::dvec3 ac = corner.c - corner.a;
  const glm::dvec3 normal = glm::cross(ab, ac);
  const glm::dvec3 from = local.origin - corner.a;
  const double facing = glm::dot(normal, local.direction);
  const double inverse = 1.0 / facing;
  const double t = -glm::dot(normal, from) * inverse;
  if (!std::isfinite(t)) {
    return std::nullopt;
  }
  const glm::dvec3 turn = glm::cross(from, local.direction);
  const double b = glm::dot(ac, turn) * -inverse;
  const double c = glm::dot(ab, turn) * inverse;
  const glm::dvec3 gradient = normal * instance.transform.inverse_linear();
  return TriangleMet{.instance = &instance,
                     .triangle = triangle,
                     .t = t,
                     .rise = std::abs(facing) / glm::length(gradient),
                     .entering = facing < 0.0,
                     .inside = b >= -outside && c >= -outside && b + c <= 1.0 + outside,
                     .sheet = false,
                     .barycentric = glm::clamp(glm::dvec2(b, c), 0.0, 1.0),
                     .normal = normal};
}

}  // namespace

std::optional<TriangleMet> meet(const MeshInstance& instance, std::uint32_t triangle,
                                const Ray& ray) {
  const std::vector<std::uint32_t>& twins = instance.mesh->twins;
  if (twins.empty() || twins[triangle] == no_twin) {
    return meet_plane(instance, triangle, ray);
  }
  if (twins[triangle] < triangle) {
    return std::nullopt;
  }
  std::optional<TriangleMet> met = meet_plane(instance, triangle, ray);
  if (met && !met->entering) {
    met = meet_plane(instance, twins[triangle], ray);
  }
  if (met) {
    met->sheet = true;
  }
  return met;
}

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): what `kind_` says is set.
AccelQuery::AccelQuery(const Accel::Index& index, const Ray& ray, const Departure& from, double end,
                       Solid::Scratch& scratch)
    : begin(-from.behind),
      index_(index),
      ray_(ray),
      from_(from),
      scratch_(scratch),
      length2_(glm::dot(ray.direction, ray.direction)),
      t_end_(end) {}

SurfaceLayer AccelQuery::layer(const SolidObject& object, const Boundary& boundary) const {
  return index_.layers.of_solid(static_cast<std::size_t>(&object - index_.scene.solids.data()),
                                boundary);
}

SurfaceLayer AccelQuery::layer(const TriangleMet& met) const {
  return index_.layers.of_mesh(static_cast<std::size_t>(met.instance - index_.scene.meshes.data()),
                               met.triangle);
}

double AccelQuery::rise(const SolidObject& object, const Boundary& boundary) const {
  return std::abs(glm::dot(object.solid.normal(boundary), ray_.direction));
}

// Does the ray come to this surface after its start? `rise()` is asked for where it may not.
template <typename Rise>
bool AccelQuery::meets(double t, bool entering, const SurfaceLayer& layer, const Rise& rise) const {
  if (layer.shared() && layer.surface == from_.layer.surface &&
      layer.along(entering) == from_.along && std::abs(t) * rise() <= from_.reach) {
    return layer.past(from_.layer, from_.along);
  }
  return t > 0.0 &&
         (t * t * length2_ > index_.near2 || t * rise() > index_.on_surface(ray_.origin));
}

bool AccelQuery::meets(const TriangleMet& met) const {
  const auto rise = [&] { return met.rise; };
  if (!meets(met.t, met.entering, layer(met), rise)) {
    return false;
  }
  // Next to its start, Embree may have a ray meet a triangle beside the one that it starts on.
  const double near = near_errors * index_.float_error(ray_.at(met.t));
  return met.inside || met.t * met.t * length2_ > near * near;
}

// Does it come before the first so far?
bool AccelQuery::closer(double t, bool entering, const SurfaceLayer& layer, double rise) const {
  if (layer.shared() && layer.surface == first_layer_.surface &&
      layer.along(entering) == first_along_ &&
      std::abs(t - t_end_) * rise <= index_.layers.place(layer)) {
    return first_layer_.past(layer, first_along_);
  }
  return t < t_end_;
}

// Calls `seen(boundary, layer)` for what the ray meets of the object, until that is false.
template <typename Seen>
void AccelQuery::each_boundary(const SolidObject& object, const Seen& seen) {
  for (auto met = object.solid.first(ray_, begin, t_end_ + slack_, scratch_); met;
       met = object.solid.next(scratch_)) {
    const SurfaceLayer at = layer(object, *met);
    if (meets(met->t, met->entering, at, [&] { return rise(object, *met); }) && !seen(*met, at)) {
      return;
    }
  }
}

bool AccelQuery::offer(const SolidObject& object) {
  bool found = false;
  each_boundary(object, [&](const Boundary& met, const SurfaceLayer& at) {
    const double gained = at.shared() ? rise(object, met) : 0.0;
    found = closer(met.t, met.entering, at, gained);
    if (found) {
      kind_ = Kind::solid;
      solid_ = &object;
      boundary_ = met;
      t_end_ = met.t;
      first_layer_ = at;
      first_along_ = at.along(met.entering);
      slack_ = at.shared() ? index_.layers.place(at) / gained : 0.0;
    }
    return false;
  });
  return found;
}

bool AccelQuery::offer(const TriangleMet& met) {
  const SurfaceLayer at = layer(met);
  if (!closer(met.t, met.entering, at, met.rise) || !meets(met)) {
    return false;
  }
  const Material& material = material_of(index_.scene, met.instance->material);
  if (material.single_sided && !met.entering) {
    return false;
  }
  if (material.alpha_cutoff > 0.0f &&
      masked(material, base_colour(index_.scene, material, met.point()))) {
    return false;
  }
  kind_ = Kind::triangle;
  triangle_ = met;
  t_end_ = met.t;
  first_layer_ = at;
  first_along_ = at.along(met.entering);
  slack_ = (2.0 * index_.padding + (at.shared() ? index_.layers.place(at) : 0.0)) / met.rise;
  return true;
}

// Does nothing but its distance, and the side it is seen from, decide whether the triangle is met?
bool AccelQuery::plain(const FloatMet& met) const {
  return met.t * met.t * length2_ > index_.near2 && met.t > 0.0 &&
         met.rise * met.rise > least_slope * least_slope * length2_ &&
         !index_.needs_double[static_cast<std::size_t>(met.instance - index_.scene.meshes.data())];
}

bool AccelQuery::offer(const FloatMet& met) {
  // What Embree finds of a triangle is wrong by up to `padding` across its plane.
  const double wrong = 2.0 * index_.padding / met.rise;
  if (plain(met)) {
    if (!met.entering && material_of(index_.scene, met.instance->material).single_sided) {
      return false;
    }
    if (met.t - wrong > t_end_ + slack_) {
      return false;
    }
    if (met.t + wrong < t_end_ - slack_) {
      kind_ = Kind::in_float;
      in_float_ = met;
      t_end_ = met.t;
      first_layer_ = {};
      slack_ = wrong;
      return true;
    }
  }
  settle();
  const std::optional<TriangleMet> exactly = meet(*met.instance, met.triangle, ray_);
  return exactly && offer(*exactly);
}

// Finds in double where the first so far is.
void AccelQuery::settle() {
  if (kind_ == Kind::in_float) {
    const FloatMet met = in_float_;
    if (const std::optional<TriangleMet> exactly = meet(*met.instance, met.triangle, ray_)) {
      kind_ = Kind::triangle;
      triangle_ = *exactly;
      t_end_ = exactly->t;
    }
  }
}

bool AccelQuery::shade(const SolidObject& object, LightPassage& out) {
  double since = 0.0;  // where the stretch began that the next boundary ends
  const glm::vec3* inside = nullptr;
  each_boundary(object, [&](const Boundary& met, const SurfaceLayer&) {
    const Material& material = material_of(index_.scene, object.materials[met.leaf]);
    out.through(material.transmission);
    if (met.entering) {
      inside = &material.absorption;
      since = met.t;
    } else {
      out.absorb(inside != nullptr ? *inside : material.absorption, since, met.t);
      inside = nullptr;
    }
    return !out.stopped();
  });
  if (inside != nullptr && !out.stopped()) {
    out.absorb(*inside, since, t_end_);
  }
  return !out.stopped();
}

bool AccelQuery::shade(const TriangleMet& met, LightPassage& out, double near) {
  if (!(met.t < t_end_) || !meets(met)) {
    return true;
  }
  const Material& material = material_of(index_.scene, met.instance->material);
  if (opaque(material)) {
    out.through(glm::vec3(0.0f), glm::vec3(0.0f), met.entering, met.t);
    return false;
  }
  const glm::vec4 base = base_colour(index_.scene, material, met.point());
  const auto mesh = static_cast<std::size_t>(met.instance - index_.scene.meshes.data());
  if (!masked(material, base) && out.first_of_passage(mesh, met.entering, met.t, near)) {
    out.through(transmission(index_.scene, material, met.point(), base),
                met.sheet ? glm::vec3(0.0f) : material.absorption, met.entering, met.t);
  }
  return !out.stopped();
}

bool AccelQuery::shade(const FloatMet& met, LightPassage& out, double near) {
  if (plain(met) && met.t < t_end_ && opaque(material_of(index_.scene, met.instance->material))) {
    out.through(glm::vec3(0.0f), glm::vec3(0.0f), true, met.t);
    return false;
  }
  const std::optional<TriangleMet> exactly = meet(*met.instance, met.triangle, ray_);
  return !exactly || shade(*exactly, out, near);
}

std::optional<Hit> AccelQuery::first() {
  settle();
  if (kind_ == Kind::solid) {
    const Solid& solid = solid_->solid;
    return Hit{.t = boundary_.t,
               .surface = solid.surface(boundary_),
               .material = solid_->materials[boundary_.leaf],
               .entering = boundary_.entering,
               .normal = solid.normal(boundary_),
               .layer = first_layer_};
  }
  if (kind_ != Kind::triangle) {
    return std::nullopt;
  }
  const MeshInstance& instance = *triangle_.instance;
  return Hit{.t = triangle_.t,
             .surface = SurfaceId{static_cast<std::uint32_t>(instance.first_face) +
                                  triangle_.point().face()},
             .material = instance.material,
             .entering = triangle_.entering,
             .normal = instance.transform.normal(triangle_.normal),
             .mesh = &instance,
             .triangle = triangle_.triangle,
             .barycentric = triangle_.barycentric,
             .sheet = triangle_.sheet,
             .layer = first_layer_};
}

float AccelQuery::reach() const {
  const auto t = static_cast<float>(t_end_ + slack_ - embree_start);
  return t + std::abs(t) * float_ulp_up;
}

}  // namespace raycat
