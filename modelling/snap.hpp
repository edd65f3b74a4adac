#pragma once

#include <span>

#include <glm/vec3.hpp>

namespace raycat {

/// Makes coordinates along one axis equal that differ by less than `tolerance`: to the one that
/// occurs most often. Faces across an axis that are flush but for rounding are flush then.
void snap(std::span<glm::dvec3> positions, double tolerance);

}  // namespace raycat
