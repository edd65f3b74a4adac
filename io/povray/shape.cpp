#include "io/povray/shape.hpp"

#include <cmath>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/transform.hpp>

#include "geometry/mesh.hpp"
#include "io/povray/text.hpp"

namespace raycat {
namespace {

Shape resized(const Sphere& shape, double factor) {
  return Sphere{.radius = factor * shape.radius};
}

Shape resized(const Box& shape, double factor) { return Box{.size = factor * shape.size}; }

Shape resized(const Cylinder& shape, double factor) {
  return Cylinder{.height = factor * shape.height,
                  .radius_top = factor * shape.radius_top,
                  .radius_bottom = factor * shape.radius_bottom};
}

Shape resized(const Capsule& shape, double factor) {
  return Capsule{.height = factor * shape.height,
                 .radius_top = factor * shape.radius_top,
                 .radius_bottom = factor * shape.radius_bottom};
}

Shape resized(const HalfSpace& shape, double /*factor*/) { return shape; }

Shape resized(const Torus& shape, double factor) {
  return Torus{.radius = factor * shape.radius, .tube = factor * shape.tube};
}

Shape resized(const MeshShape& shape, double /*factor*/) { return shape; }

// POV-Ray's tolerances are absolute, also where a shape is before it is transformed: by what a
// shape of the size of this box should be multiplied, 1 for usual ones.
double usual_size(const Bounds& box) {
  const double size = box.empty() || !box.finite() ? 1.0 : glm::length(box.half_size());
  return size == 0.0 || (size > 1e-2 && size < 1e4) ? 1.0 : 1.0 / size;
}

std::string sphere(double height, double radius) {
  return fmt::format("sphere {{ {}, {} }}", pov_vector({0, height, 0}), radius);
}

std::string frustum(double bottom, double bottom_radius, double top, double top_radius) {
  return fmt::format("cone {{ {}, {}, {}, {} }}", pov_vector({0, bottom, 0}), bottom_radius,
                     pov_vector({0, top, 0}), top_radius);
}

std::string open_shape(const Sphere& shape) { return fmt::format("sphere {{ 0, {}", shape.radius); }

std::string open_shape(const Box& shape) {
  return fmt::format("box {{ {}, {}", pov_vector(-0.5 * shape.size), pov_vector(0.5 * shape.size));
}

std::string open_shape(const Cylinder& shape) {
  const std::string bottom = pov_vector({0, -0.5 * shape.height, 0});
  const std::string top = pov_vector({0, 0.5 * shape.height, 0});
  return shape.radius_top == shape.radius_bottom
             ? fmt::format("cylinder {{ {}, {}, {}", bottom, top, shape.radius_top)
             : fmt::format("cone {{ {}, {}, {}, {}", bottom, shape.radius_bottom, top,
                           shape.radius_top);
}

// Two balls and the cone that touches both, between the circles where it does.
std::string open_shape(const Capsule& shape) {
  const double half = 0.5 * shape.height;
  const double fall = shape.radius_bottom - shape.radius_top;
  if (std::abs(fall) >= shape.height) {  // one ball holds the other
    const bool bottom = fall > 0.0;
    return fmt::format("sphere {{ {}, {}", pov_vector({0, bottom ? -half : half, 0}),
                       bottom ? shape.radius_bottom : shape.radius_top);
  }
  const double sine = fall / shape.height;
  const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
  std::string text = fmt::format(
      "merge {{ {}", frustum(-half + sine * shape.radius_bottom, cosine * shape.radius_bottom,
                             half + sine * shape.radius_top, cosine * shape.radius_top));
  for (const auto& [height, radius] :
       {std::pair(-half, shape.radius_bottom), std::pair(half, shape.radius_top)}) {
    text += radius > 0.0 ? fmt::format(" {}", sphere(height, radius)) : "";
  }
  return text;
}

std::string open_shape(const HalfSpace& /*shape*/) { return "plane { y, 0"; }

// POV-Ray 3.7 takes the middle of a spindle for a hole. As a quartic it has the surface of its
// lens too, which the ball that touches the lens from outside and the spindle from inside hides.
std::string open_shape(const Torus& shape) {
  const double r = shape.radius;
  const double t = shape.tube;
  if (t < r) {
    return fmt::format("torus {{ {}, {} sturm", r, t);
  }
  // (x^2 + y^2 + z^2 + k)^2 - 4 r^2 (x^2 + z^2), by the powers x^4 x^3y ... z 1.
  const double k = (r - t) * (r + t);
  const double across = 2.0 * k - 4.0 * r * r;
  const std::string quartic = fmt::format(
      "quartic {{ <1, 0, 0, 0, 2, 0, 0, 2, 0, {0}, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, "
      "{1}, 0, 0, 0, 0, 1, 0, {0}, 0, {2}> sturm }}",
      across, 2.0 * k, k * k);
  return t == r ? quartic.substr(0, quartic.size() - 2)
                : fmt::format("merge {{ {} {}", quartic, sphere(0.0, std::sqrt(-k)));
}

template <typename Item, typename Text>
std::string list(std::string_view name, const std::vector<Item>& items, const Text& text) {
  std::string out = fmt::format("  {} {{ {}", name, items.size());
  for (const Item& item : items) {
    out += ",\n    ";
    out += text(item);
  }
  return out + "\n  }\n";
}

std::string open_shape(const MeshShape& /*shape*/) { return ""; }  // declared apart

}  // namespace

std::string PovShapes::open(const PlacedShape& shape) {
  if (const auto* mesh = std::get_if<MeshShape>(&shape.shape())) {
    return open(declare((*mesh)->mesh(), {}, true), shape.transform());
  }
  const double factor = usual_size(bounds(shape.shape()));
  const Shape usual =
      std::visit([&](const auto& one) { return resized(one, factor); }, shape.shape());
  return std::visit([&](const auto& one) { return open_shape(one); }, usual) +
         place(shape.transform(), {.factor = factor});
}

std::string PovShapes::open(const MeshInstance& instance) {
  return open(declare(instance.mesh->triangles, instance.mesh->normals, false), instance.transform);
}

std::string PovShapes::open(const Declared& mesh, const Affine& transform) const {
  return fmt::format("object {{ {}{}", mesh.name, place(transform, mesh.form));
}

std::string PovShapes::place(const Affine& transform, const Form& form) const {
  glm::dmat4 matrix = glm::translate(transform.matrix(), form.centre);
  if (form.factor != 1.0) {
    matrix = glm::scale(matrix, glm::dvec3(1.0 / form.factor));
  }
  return pov_matrix(scale_ == 1.0 ? matrix : glm::scale(glm::dvec3(scale_)) * matrix);
}

const PovShapes::Declared& PovShapes::declare(const TriangleMesh& mesh,
                                              const std::vector<glm::vec3>& normals, bool closed) {
  const auto [place, is_new] = meshes_.try_emplace(&mesh);
  Declared& declared = place->second;
  if (!is_new) {
    return declared;
  }
  declared.name = fmt::format("Mesh{}", meshes_.size());
  // POV-Ray keeps vertices in single precision, which must not go into a place far off.
  const Bounds box = bounds(mesh);
  if (!box.empty() && glm::length(box.center()) > glm::length(box.half_size())) {
    declared.form.centre = box.center();
  }
  declared.form.factor = usual_size(box);
  const Form form = declared.form;
  declarations_ += fmt::format("#declare {} = mesh2 {{\n", declared.name) +
                   list("vertex_vectors", mesh.positions, [&](const glm::dvec3& v) {
                     return pov_vector(form.factor * (v - form.centre));
                   });
  if (!normals.empty()) {
    declarations_ += list("normal_vectors", normals,
                          [](const glm::vec3& n) { return pov_vector(glm::dvec3(n)); });
  }
  declarations_ += list("face_indices", mesh.triangles, [](const glm::uvec3& t) {
    return fmt::format("<{}, {}, {}>", t.x, t.y, t.z);
  });
  // Along no axis and no diagonal, where a line would go through edges.
  declarations_ += closed ? "  inside_vector <0.3127, 0.8519, 0.4201>\n}\n" : "}\n";
  return declared;
}

std::string PovShapes::take_declarations() { return std::exchange(declarations_, ""); }

}  // namespace raycat
