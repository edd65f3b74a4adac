#pragma once

#include <string>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace raycat {

/// Values as POV-Ray's scene language has them, with digits enough to be read back as they were.
std::string pov_vector(const glm::dvec3& vector);
std::string pov_colour(const glm::vec3& linear);

/// A transform clause with a blank before it; nothing for the identity.
std::string pov_matrix(const glm::dmat4& matrix);

/// The rest of a line as a comment, whatever `text` holds.
std::string pov_comment(const std::string& text);

}  // namespace raycat
