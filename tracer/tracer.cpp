#include "tracer/tracer.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtx/component_wise.hpp>

#include "tracer/material_at.hpp"
#include "tracer/pbr.hpp"

namespace raycat {
namespace {

const glm::vec3 black(0.0f);

// The interpolated normal where the mesh has normals; it can fail to be one, and then the
// triangle's own serves.
glm::dvec3 shading_normal(const Hit& hit) {
  if (hit.mesh == nullptr || hit.mesh->mesh->normals.empty()) {
    return hit.normal;
  }
  const SurfaceMesh& surface = *hit.mesh->mesh;
  const glm::uvec3 i = surface.triangles.triangles[hit.triangle];
  const glm::dvec2 v = hit.barycentric;
  const glm::dvec3 local = (1.0 - v.x - v.y) * glm::dvec3(surface.normals[i.x]) +
                           v.x * glm::dvec3(surface.normals[i.y]) +
                           v.y * glm::dvec3(surface.normals[i.z]);
  const glm::dvec3 normal = hit.mesh->transform.normal(local);
  return glm::dot(normal, hit.normal) > 0.0 ? normal : hit.normal;
}

struct Illumination {
  glm::dvec3 way{0.0};  // unit, towards the light
  double distance = std::numeric_limits<double>::infinity();
  float strength = 0.0f;
};

// KHR_lights_punctual: a spot fades smoothly from its inner to its outer cone.
float cone(const Light& light, const glm::dvec3& way) {
  const double cosine = -glm::dot(way, light.direction);
  const double outer = std::cos(light.outer_cone);
  const double inner = std::cos(light.inner_cone);
  const double fade = glm::clamp((cosine - outer) / std::max(inner - outer, 1e-9), 0.0, 1.0);
  return static_cast<float>(fade * fade);
}

// By KHR_lights_punctual; the factor that brings the light to nothing at its range.
float window(double distance, double range) {
  if (std::isinf(range)) {
    return 1.0f;
  }
  const double ratio = distance / range;
  return static_cast<float>(glm::clamp(1.0 - ratio * ratio * ratio * ratio, 0.0, 1.0));
}

Illumination illuminate(const Light& light, const glm::dvec3& point) {
  if (light.kind == Light::Kind::directional) {
    return {.way = -light.direction, .strength = 1.0f};
  }
  const glm::dvec3 way = light.position - point;
  const double distance = glm::length(way);
  if (!(distance > 0.0)) {
    return {};
  }
  Illumination at{
      .way = way / distance, .distance = distance, .strength = window(distance, light.range)};
  if (light.inverse_square) {
    at.strength /= static_cast<float>(distance * distance);
  }
  if (light.kind == Light::Kind::spot) {
    at.strength *= cone(light, at.way);
  }
  return at;
}

// Schlick's approximation: how far the reflectance is on its way from that at normal incidence
// to that at grazing.
float schlick(double cosine) {
  const double m = glm::clamp(1.0 - cosine, 0.0, 1.0);
  return static_cast<float>(m * m * m * m * m);
}

class Shader {
 public:
  Shader(const Accel& accel, const Ray& ray, const Hit& hit, TraceScratch& scratch)
      : accel_(accel),
        scene_(accel.scene()),
        material_(material_of(scene_, hit.material)),
        ray_(ray),
        hit_(hit),
        way_(glm::normalize(ray.direction)),
        scratch_(scratch) {
    if (hit.mesh != nullptr) {
      base_ = base_colour(scene_, material_, point());
      if (material_.varying) {
        varied_ = material_at(scene_, *material_.varying, point(), base_);
      }
    }
    // Towards the side the surface is seen from.
    side_ = glm::dot(hit.normal, ray.direction) > 0.0 ? -1.0 : 1.0;
    facet_ = side_ * hit.normal;
    normal_ = side_ * shading_normal(hit);
    if (glm::dot(normal_, ray.direction) > 0.0) {
      normal_ = facet_;
    }
    near_ = accel.leave(ray, hit, facet_);
  }

  void light(Shading& out) {
    // What varies has been made of the base colour already.
    const glm::vec3 base = varied_ ? glm::vec3(1.0f) : glm::vec3(base_);
    const glm::vec3 tint = material_.textured_emission ? base : glm::vec3(1.0f);
    out.colour = here().emission * tint + here().ambient * base * scene_.ambient_light;
    if (!scene_.lights.empty() && counts_lights()) {
      lift();
      for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
        if (add(scene_.lights[i], base, out.colour)) {
          out.lights |= LightMask{1} << i;
        }
      }
    }
    if (material_.blend) {
      out.colour *= glm::min(1.0f, material_.alpha * base_.a);
    }
  }

  bool reached_by(const Light& light) {
    if (!counts_lights()) {
      return false;
    }
    lift();
    glm::vec3 colour(0.0f);
    return add(light, glm::vec3(1.0f), colour);
  }

  void spawn(const Media& media, Shading& out) {
    const bool transmits =
        material_.blend ? material_.alpha < 1.0f || !untextured() : material_.transmission != black;
    out.k_s = material_.reflection == black ? black : here().reflection;
    out.reflection_weight = glm::compMax(material_.reflection);
    bool total = false;
    double cosine = -glm::dot(way_, normal_);
    if (transmits) {
      total = !refract(media, cosine, out);
    }
    if (material_.fresnel && !total) {
      const float growth = schlick(cosine);
      out.k_s += (here().grazing_reflection - out.k_s) * growth;
      out.k_t *= 1.0f - growth;
    }
    if (total) {
      out.k_s += here().transmission;
      out.reflection_weight = glm::compMax(material_.reflection + material_.transmission);
    }
    if (material_.reflection != black || total) {
      reflect(out);
    }
  }

 private:
  /// The constants here. What exists and what does not, the material's factors say.
  const Material& here() const { return varied_ ? *varied_ : material_; }

  bool counts_lights() const {
    return scene_.counted_lights == CountedLights::visible || shows_lights();
  }

  // Is O_d or O_s anything but zero, by the factors? One of metal or transmission that a texture
  // is multiplied with says no more than that the texture tells where it is.
  bool shows_lights() const {
    if (material_.blend && material_.alpha == 0.0f) {
      return false;
    }
    if (material_.diffuse != black || material_.specular != black || !varied_) {
      return material_.diffuse != black || material_.specular != black;
    }
    Pbr least = material_.varying->factors;
    least.metallic = material_.varying->metallic_roughness ? 0.0 : least.metallic;
    least.transmission = material_.varying->transmission ? 0.0 : least.transmission;
    const Material most = whitted(least);
    return most.diffuse != black || most.specular != black;
  }

  MeshPoint point() const {
    return {.mesh = *hit_.mesh->mesh, .triangle = hit_.triangle, .barycentric = hit_.barycentric};
  }

  // Where normals are interpolated, shadow rays start on the smooth surface that they stand for,
  // not within the triangle: else the line where light ends would follow the triangles (Hanika,
  // "Hacking the Shadow Terminator", Ray Tracing Gems II).
  void lift() {
    lifted_ = near_;
    if (hit_.mesh == nullptr || hit_.mesh->mesh->normals.empty()) {
      return;
    }
    const SurfaceMesh& surface = *hit_.mesh->mesh;
    const glm::uvec3 corners = surface.triangles.triangles[hit_.triangle];
    const glm::dvec2 v = hit_.barycentric;
    const glm::dvec3 weights(1.0 - v.x - v.y, v.x, v.y);
    const glm::dvec3 point = ray_.at(hit_.t);
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 normal =
          side_ * hit_.mesh->transform.normal(glm::dvec3(surface.normals[corners[k]]));
      const glm::dvec3 corner = hit_.mesh->transform.point(surface.triangles.positions[corners[k]]);
      const double below = glm::dot(point - corner, normal);
      if (below < 0.0 && glm::dot(normal, facet_) > 0.0) {
        lifted_ -= weights[k] * below * normal;
      }
    }
  }

  // Adds what one light contributes; false if it is not visible.
  bool add(const Light& light, const glm::vec3& base, glm::vec3& colour) {
    const glm::dvec3 point = ray_.at(hit_.t);
    const Illumination at = illuminate(light, point);
    const double facing = glm::dot(normal_, at.way);
    if (at.strength <= 0.0f || facing <= 0.0) {
      return false;
    }
    ++scratch_.rays.shadow;
    Departure from = accel_.departure(ray_, hit_, at.way);
    if (glm::dot(facet_, at.way) <= 0.0) {
      from.mesh = nullptr;  // an interpolated normal lets light come through the triangle itself
    }
    const glm::vec3 passed = accel_.transmittance({.origin = lifted_, .direction = at.way},
                                                  light.kind == Light::Kind::directional
                                                      ? at.distance
                                                      : glm::distance(light.position, lifted_),
                                                  scratch_.solid, from);
    if (passed == black) {
      return false;
    }
    const glm::vec3 arriving = at.strength * passed;
    colour += here().diffuse * base * light.diffuse * arriving * static_cast<float>(facing);
    if (here().specular != black) {
      const double halfway = glm::dot(normal_, glm::normalize(at.way - way_));
      colour += here().specular * light.specular * arriving *
                std::pow(static_cast<float>(glm::max(halfway, 0.0)), here().shininess);
    }
    return true;
  }

  // Makes the refracted ray by Snell's law and sets `cosine` to that of the angle on the thinner
  // side; false on total internal reflection.
  bool refract(const Media& media, double& cosine, Shading& out) {
    out.k_t = hit_.mesh == nullptr ? material_.transmission
                                   : transmission(scene_, material_, point(), base_);
    out.refraction_weight = material_.blend && untextured() ? glm::compMax(out.k_t)
                                                            : glm::compMax(material_.transmission);
    const glm::dvec3 far = accel_.leave(ray_, hit_, -facet_);
    if (material_.thin || hit_.sheet) {
      out.refraction = child(far, way_);
      out.media = media;
      return true;
    }
    out.media = passed(media, hit_);
    const float from = before(media);
    const float to = beyond(out.media);
    const double eta = static_cast<double>(from) / static_cast<double>(to);
    const double under = 1.0 - eta * eta * (1.0 - cosine * cosine);
    if (under < 0.0) {
      out.k_t = black;
      return false;
    }
    if (hit_.layer.shared()) {
      out.media.aim(to);
    }
    const double beyond_cosine = std::sqrt(under);
    glm::dvec3 direction = glm::normalize(eta * way_ + (eta * cosine - beyond_cosine) * normal_);
    if (glm::dot(direction, facet_) >= 0.0) {
      direction = way_;  // an interpolated normal that bends the ray back out of the surface
    }
    out.refraction = child(far, direction);
    cosine = eta > 1.0 ? beyond_cosine : cosine;
    return true;
  }

  // The media of a ray when it has passed a surface.
  Media passed(const Media& media, const Hit& hit) const {
    const ObjectId object = scene_.surfaces.object(hit.surface);
    const Material& material = material_of(scene_, hit.material);
    return hit.entering ? media.entered(object, material.ior, material.absorption)
                        : media.left(object);
  }

  // The index of refraction that the ray's direction is of. A ray that leaves an object it started
  // in has been in its material all the way; one that leaves an object of which it is no longer in
  // the material changes nothing.
  float before(const Media& media) const {
    const ObjectId object = scene_.surfaces.object(hit_.surface);
    const bool own = !hit_.entering && !media.aimed() && !media.within_another_than(object);
    return own ? material_.ior : media.ior();
  }

  // The index of refraction past all surfaces that coincide with this one, up to an opaque one: a
  // ray goes straight from the one medium into the other, of `after` passing this one alone.
  float beyond(Media after) const {
    Hit at = hit_;
    while (const std::optional<Hit> next = accel_.next_at(ray_, at, scratch_.solid)) {
      const Material& material = material_of(scene_, next->material);
      if (!material.blend && material.transmission == black) {
        break;
      }
      if (!material.thin && !next->sheet) {
        after = passed(after, *next);
      }
      at = *next;
    }
    return after.ior();
  }

  void reflect(Shading& out) {
    glm::dvec3 direction = glm::reflect(way_, normal_);
    if (glm::dot(direction, facet_) <= 0.0) {
      direction = glm::reflect(way_, facet_);
    }
    out.reflection = child(near_, glm::normalize(direction));
  }

  ChildRay child(const glm::dvec3& origin, const glm::dvec3& direction) const {
    return {{.origin = origin, .direction = direction}, accel_.departure(ray_, hit_, direction)};
  }

  bool untextured() const {
    return !material_.base_texture && (hit_.mesh == nullptr || hit_.mesh->mesh->colours.empty());
  }

  const Accel& accel_;
  const Scene& scene_;
  const Material& material_;
  const Ray& ray_;
  const Hit& hit_;
  glm::vec4 base_{1.0f};
  std::optional<Material> varied_;
  glm::dvec3 way_;     // unit, along the ray
  glm::dvec3 facet_;   // unit, the surface's own normal
  glm::dvec3 normal_;  // unit, for shading
  glm::dvec3 near_;    // where rays start that stay on this side
  glm::dvec3 lifted_;  // where shadow rays do
  double side_;        // 1 if the surface is seen from outside, else -1
  TraceScratch& scratch_;
};

}  // namespace

Shading shade(const Accel& accel, const Ray& ray, const Hit& hit, const Media& media, bool spawn,
              TraceScratch& scratch) {
  Shading out;
  Shader shader(accel, ray, hit, scratch);
  shader.light(out);
  if (spawn) {
    shader.spawn(media, out);
  }
  return out;
}

Shading spawn(const Accel& accel, const Ray& ray, const Hit& hit, const Media& media,
              TraceScratch& scratch) {
  Shading out;
  Shader(accel, ray, hit, scratch).spawn(media, out);
  return out;
}

bool reaches(const Accel& accel, const Ray& ray, const Hit& hit, std::size_t light,
             TraceScratch& scratch) {
  return Shader(accel, ray, hit, scratch).reached_by(accel.scene().lights[light]);
}

}  // namespace raycat
