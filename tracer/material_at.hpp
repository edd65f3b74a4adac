#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "tracer/material.hpp"
#include "tracer/scene.hpp"

namespace raycat {

/// The material's base texture and the vertices' colour at a point, linear RGBA: what the base
/// colour factors are multiplied with.
glm::vec4 base_colour(const Scene& scene, const Material& material, const MeshPoint& point);

/// The constants at a point of a `varying` material, with its base colour times `base`: what
/// glTF's parameters make of its factors and textures there. What is not a constant of eq. (1) is
/// not set.
Material material_at(const Scene& scene, const VaryingPbr& varying, const MeshPoint& point,
                     const glm::vec4& base);

/// The part of the light that the material lets through at a point of base colour `base`.
glm::vec3 transmission(const Scene& scene, const Material& material, const MeshPoint& point,
                       const glm::vec4& base);

}  // namespace raycat
