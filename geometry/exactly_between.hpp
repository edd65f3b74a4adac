#pragma once

#include <glm/vec3.hpp>

namespace raycat {

/// Does `point` lie on the segment from `a` to `b`, and is it neither of them? Exact, unless
/// products of coordinates overflow or underflow.
bool exactly_between(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b);

}  // namespace raycat
