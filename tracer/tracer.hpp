#pragma once

#include <cstdint>
#include <optional>

#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "raytree/ray_tree.hpp"
#include "tracer/accel.hpp"
#include "tracer/media.hpp"

namespace raycat {

/// Rays traced, by what they were for.
struct RayCounts {
  std::uint64_t camera = 0;
  std::uint64_t reflection = 0;
  std::uint64_t refraction = 0;
  std::uint64_t shadow = 0;

  RayCounts& operator+=(const RayCounts& other) noexcept {
    camera += other.camera;
    reflection += other.reflection;
    refraction += other.refraction;
    shadow += other.shadow;
    return *this;
  }
};

/// What a thread needs to trace rays, reused from ray to ray.
struct TraceScratch {
  Solid::Scratch solid;
  RayCounts rays;
};

/// A ray that leaves a hit.
struct ChildRay : Ray {
  Departure from;
};

/// Eq. (1) at one hit, but for the light that child rays bring.
struct Shading {
  glm::vec3 colour{0.0f};  ///< O_e + O_a S_a + the sum over visible lights
  LightMask lights = 0;    ///< those that count

  std::optional<ChildRay> refraction;  ///< where the material has one
  std::optional<ChildRay> reflection;
  glm::vec3 k_t{0.0f};             ///< what I_t is multiplied with here
  glm::vec3 k_s{0.0f};             ///< what I_r is multiplied with here
  float refraction_weight = 0.0f;  ///< greatest channel of the material's factor
  float reflection_weight = 0.0f;
  Media media;  ///< that the refracted ray travels in
};

/// Shades `hit` of `ray`, which travels in `media`. Without `spawn`, at the last level, there
/// are no child rays.
///
/// A light is visible if it lies in front of the surface, its cone and range take in the point
/// and no opaque surface is between; through transmissive ones it shines weakened by their k_t.
/// Surfaces are lit from the side they are seen from. Which visible lights count says
/// `Scene::counted_lights`; whether O_d and O_s are zero, the material's factors, of which those of
/// metal and transmission may be less where a texture is multiplied with them. Whether there are
/// child rays depends on the factors alone, and on total internal reflection, which sends what
/// could not be refracted with the reflected ray.
Shading shade(const Accel& accel, const Ray& ray, const Hit& hit, const Media& media, bool spawn,
              TraceScratch& scratch);

/// The child rays of `shade` alone, without any light.
Shading spawn(const Accel& accel, const Ray& ray, const Hit& hit, const Media& media,
              TraceScratch& scratch);

/// Does one light, by number, count at the hit, as `shade` has it?
bool reaches(const Accel& accel, const Ray& ray, const Hit& hit, std::size_t light,
             TraceScratch& scratch);

namespace detail {

template <Recorder R>
class Branch {
 public:
  Branch(const Accel& accel, int levels, R& recorder, TraceScratch& scratch)
      : accel_(accel), levels_(levels), recorder_(recorder), scratch_(scratch) {}

  glm::vec3 trace(const ChildRay& ray, const Media& media, HeapPosition position, float weight) {
    const std::optional<Hit> hit = accel_.closest(ray, scratch_.solid, ray.from);
    if (!hit) {
      return accel_.scene().background;
    }
    const Shading shading = shade(accel_, ray, *hit, media, level(position) < levels_, scratch_);
    glm::vec3 colour = shading.colour;
    if (shading.refraction) {
      ++scratch_.rays.refraction;
      colour += shading.k_t * trace(*shading.refraction, shading.media, refracted(position),
                                    weight * shading.refraction_weight);
    }
    if (shading.reflection) {
      ++scratch_.rays.reflection;
      colour += shading.k_s * trace(*shading.reflection, media, reflected(position),
                                    weight * shading.reflection_weight);
    }
    if (media.absorption() != glm::vec3(0.0f)) {
      const double distance = hit->t * glm::length(ray.direction);
      colour *= glm::exp(-static_cast<float>(distance) * media.absorption());
    }
    recorder_.push_back({.position = position,
                         .lights = shading.lights,
                         .surface = hit->surface,
                         .weight = weight});
    return colour;
  }

 private:
  const Accel& accel_;
  int levels_;
  R& recorder_;
  TraceScratch& scratch_;
};

}  // namespace detail

/// The light that comes back along a camera ray by eq. (1), linear RGB, and to `recorder` each
/// intersection on the way, children before their parent (Section 2.1). The tree has up to
/// `levels` levels, from 1 to `most_levels`.
template <Recorder R>
glm::vec3 trace(const Accel& accel, const Ray& ray, int levels, R& recorder,
                TraceScratch& scratch) {
  ++scratch.rays.camera;
  return detail::Branch<R>(accel, levels, recorder, scratch).trace({ray, {}}, Media(), root, 1.0f);
}

}  // namespace raycat
