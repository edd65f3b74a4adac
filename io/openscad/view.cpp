#include "io/openscad/view.hpp"

#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include "io/files/load_error.hpp"
#include "io/openscad/lexer.hpp"

namespace raycat::openscad {

namespace {

// Past this, neighbouring pixels look the same way.
constexpr double farthest = 1e12;

struct Settings {
  glm::dvec3 target{0.0};
  glm::dvec3 rotation{55.0, 0.0, 25.0};
  double distance = 140.0;
  double field_of_view = 22.5;
};

[[noreturn]] void fail(const std::filesystem::path& file, const Assignment& assignment,
                       const std::string& range) {
  throw LoadError(file, line_place(assignment.line),
                  fmt::format("{} must be {}", assignment.name, range));
}

glm::dvec3 vector(const std::filesystem::path& file, const Assignment& assignment) {
  const std::string range = fmt::format("[x, y, z], of numbers up to {:g}", farthest);
  const Vector* const from = assignment.value.vector();
  if (from == nullptr || from->size() != 3) {
    fail(file, assignment, range);
  }
  glm::dvec3 to{0.0};
  for (int axis = 0; axis < 3; ++axis) {
    const double* const number = (*from)[static_cast<std::size_t>(axis)].number();
    if (number == nullptr || std::abs(*number) > farthest) {
      fail(file, assignment, range);
    }
    to[axis] = *number;
  }
  return to;
}

double number(const std::filesystem::path& file, const Assignment& assignment, double below) {
  const double* const from = assignment.value.number();
  if (from == nullptr || !(*from > 0.0 && *from < below)) {
    fail(file, assignment, fmt::format("a number above 0 and below {:g}", below));
  }
  return *from;
}

// Around x, then y, then z, like OpenSCAD's rotate().
glm::dmat3 rotation(const glm::dvec3& degrees) {
  const glm::dvec3 c = glm::cos(glm::radians(degrees));
  const glm::dvec3 s = glm::sin(glm::radians(degrees));
  const glm::dmat3 x(1.0, 0.0, 0.0, 0.0, c.x, s.x, 0.0, -s.x, c.x);
  const glm::dmat3 y(c.y, 0.0, -s.y, 0.0, 1.0, 0.0, s.y, 0.0, c.y);
  const glm::dmat3 z(c.z, s.z, 0.0, -s.z, c.z, 0.0, 0.0, 0.0, 1.0);
  return z * y * x;
}

}  // namespace

glm::dvec3 default_direction() { return rotation(Settings{}.rotation)[2]; }

std::optional<Camera> view(const std::filesystem::path& file, const File& parsed) {
  Settings settings;
  bool any = false;
  for (const Assignment& assignment : parsed.assignments) {
    if (assignment.name == "$vpt") {
      settings.target = vector(file, assignment);
    } else if (assignment.name == "$vpr") {
      settings.rotation = vector(file, assignment);
    } else if (assignment.name == "$vpd") {
      settings.distance = number(file, assignment, farthest);
    } else if (assignment.name == "$vpf") {
      settings.field_of_view = number(file, assignment, 180.0);
    } else {
      continue;
    }
    any = true;
  }
  if (!any) {
    return {};
  }
  // Without rotation the view is straight down, +Y up in the image.
  const glm::dmat3 turned = rotation(settings.rotation);
  return Camera{.name = "view",
                .eye = settings.target + settings.distance * turned[2],
                .right = turned[0],
                .up = turned[1],
                .forward = -turned[2],
                .half_height = std::tan(0.5 * glm::radians(settings.field_of_view))};
}

}  // namespace raycat::openscad
