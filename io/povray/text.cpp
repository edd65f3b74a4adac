#include "io/povray/text.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace raycat {
namespace {

// Zeros have no sign.
template <typename Vector>
std::string components(const Vector& v) {
  return fmt::format("{}, {}, {}", v.x + 0, v.y + 0, v.z + 0);
}

}  // namespace

std::string pov_vector(const glm::dvec3& vector) { return fmt::format("<{}>", components(vector)); }

std::string pov_colour(const glm::vec3& linear) {
  return fmt::format("rgb <{}>", components(linear));
}

// POV-Ray's rows are our columns: where the axes go, then the origin.
std::string pov_matrix(const glm::dmat4& matrix) {
  if (matrix == glm::dmat4(1.0)) {
    return "";
  }
  std::string text;
  for (int column = 0; column < 4; ++column) {
    text += fmt::format("{}{}", column == 0 ? "" : ", ", components(matrix[column]));
  }
  return fmt::format(" matrix <{}>", text);
}

std::string pov_comment(const std::string& text) {
  std::string safe = text;
  std::ranges::replace_if(
      safe, [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
  return fmt::format("// {}\n", safe);
}

}  // namespace raycat
