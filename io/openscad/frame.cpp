#include "io/openscad/frame.hpp"

#include <algorithm>
#include <array>

#include <glm/common.hpp>

#include "io/openscad/parameters.hpp"

namespace raycat::openscad {

glm::dmat4 matrix_of(Context& context, const Node& node) {
  const Parameters parameters(context, node, {"m"}, {});
  const Vector& rows = parameters.vector("m");
  const char* const shape = "m must be 4 rows of 4 numbers";
  if (rows.size() != 4) {
    parameters.fail(shape);
  }
  glm::dmat4 matrix(1.0);
  for (int row = 0; row < 4; ++row) {
    const Vector* const numbers = rows[static_cast<std::size_t>(row)].vector();
    if (numbers == nullptr || numbers->size() != 4) {
      parameters.fail(shape);
    }
    for (int column = 0; column < 4; ++column) {
      const Value& value = (*numbers)[static_cast<std::size_t>(column)];
      if (std::holds_alternative<Unknown>(value.is)) {
        continue;  // keeps the identity's
      }
      if (value.number() == nullptr) {
        parameters.fail(shape);
      }
      matrix[column][row] = *value.number();
    }
  }
  if (matrix[0][3] != 0.0 || matrix[1][3] != 0.0 || matrix[2][3] != 0.0) {
    context.warn(node, "the fourth row counts only by its last number");
  }
  matrix = matrix / matrix[3][3];
  matrix[0][3] = matrix[1][3] = matrix[2][3] = 0.0;
  matrix[3][3] = 1.0;
  return matrix;
}

std::optional<glm::vec3> colour_of(Context& context, const Node& node) {
  const Parameters parameters(context, node, {"c", "alpha"}, {});
  const Vector& numbers = parameters.vector("c");
  if (numbers.size() != 3 && numbers.size() != 4) {
    parameters.fail("the colour must be [r, g, b, a]");
  }
  std::array<double, 4> colour = {-1.0, -1.0, -1.0, 1.0};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i].number() == nullptr && !std::holds_alternative<Unknown>(numbers[i].is)) {
      parameters.fail("the colour must be [r, g, b, a]");
    }
    colour[i] = numbers[i].number() == nullptr ? -1.0 : *numbers[i].number();
  }
  if (std::ranges::any_of(colour, [](double c) { return c < 0.0; })) {
    return {};
  }
  if (std::ranges::any_of(colour, [](double c) { return c > 1.0; })) {
    context.warn(node, "components above 1 count as 1");
  }
  if (colour[3] < 1.0) {
    context.warn_of_alpha(node);
  }
  return glm::min(glm::vec3(glm::dvec3(colour[0], colour[1], colour[2])), glm::vec3(1.0f));
}

}  // namespace raycat::openscad
