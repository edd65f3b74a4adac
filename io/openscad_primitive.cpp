#include "io/openscad_primitive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "geometry/mesh.hpp"
#include "geometry/mesh_faces.hpp"
#include "io/openscad_lexer.hpp"
#include "io/openscad_parameters.hpp"
#include "io/scene_file.hpp"

namespace raycat::openscad {

namespace {

// About 4 GB of meshes.
constexpr std::uint64_t most_triangles = 20'000'000;

glm::dvec3 point(const Parameters& parameters, const Value& value, std::size_t index) {
  const Vector* const from = value.vector();
  glm::dvec3 to{0.0};
  if (from == nullptr || from->size() != 3) {
    parameters.fail(fmt::format("point {} must be [x, y, z]", index));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double* const number = (*from)[static_cast<std::size_t>(axis)].number();
    if (number == nullptr) {
      parameters.fail(fmt::format("point {} must be [x, y, z]", index));
    }
    to[axis] = *number;
  }
  return to;
}

std::vector<std::uint32_t> polygon(const Parameters& parameters, const Value& value,
                                   std::size_t face, std::size_t points) {
  const Vector* const from = value.vector();
  if (from == nullptr) {
    parameters.fail(fmt::format("face {} must be a vector of point numbers", face));
  }
  std::vector<std::uint32_t> corners;
  corners.reserve(from->size());
  for (const Value& corner : *from) {
    const double* const number = corner.number();
    if (number == nullptr || *number != std::floor(*number)) {
      parameters.fail(fmt::format("face {} must be a vector of point numbers", face));
    }
    if (!(*number >= 0.0 && *number < static_cast<double>(points))) {
      parameters.fail(
          fmt::format("face {} has point {:g}, but there are {} points", face, *number, points));
    }
    corners.push_back(static_cast<std::uint32_t>(*number));
  }
  std::ranges::reverse(corners);  // OpenSCAD's are clockwise seen from outside
  return corners;
}

double signed_volume(const TriangleMesh& mesh) {
  const glm::dvec3 centre = bounds(mesh).center();
  double sum = 0.0;
  for (const glm::uvec3& triangle : mesh.triangles) {
    const glm::dvec3 a = mesh.positions[triangle.x] - centre;
    const glm::dvec3 b = mesh.positions[triangle.y] - centre;
    const glm::dvec3 c = mesh.positions[triangle.z] - centre;
    sum += glm::dot(a, glm::cross(b, c));
  }
  return sum / 6.0;
}

}  // namespace

PrimitiveMaker::PrimitiveMaker(std::filesystem::path file, const FacetRule& facets,
                               std::vector<std::string>& warnings)
    : file_(std::move(file)), facets_(facets), warnings_(warnings) {}

std::optional<Primitive> PrimitiveMaker::make(const Node& node) {
  if (node.name == "cube") {
    return cube(node);
  }
  if (node.name == "sphere") {
    return sphere(node);
  }
  return node.name == "cylinder" ? cylinder(node) : polyhedron(node);
}

std::optional<Primitive> PrimitiveMaker::cube(const Node& node) {
  const Parameters parameters(file_, node, {"size", "center"}, {}, warnings_);
  glm::dvec3 size{1.0};
  if (const Value* const value = parameters.find("size")) {
    if (const Vector* const sides = value->vector(); sides != nullptr && sides->size() == 3) {
      for (int axis = 0; axis < 3; ++axis) {
        const Value& side = (*sides)[static_cast<std::size_t>(axis)];
        if (std::holds_alternative<Unknown>(side.is)) {
          break;  // OpenSCAD reads no further, so that the rest keeps its default as well
        }
        if (side.number() == nullptr) {
          parameters.fail("size must be a number or [x, y, z]");
        }
        size[axis] = *side.number();
      }
    } else if (value->number() != nullptr) {
      size = glm::dvec3(*value->number());
    } else {
      parameters.fail("size must be a number or [x, y, z]");
    }
  }
  const bool centred = parameters.flag("center", false);
  if (!(size.x > 0.0 && size.y > 0.0 && size.z > 0.0)) {
    return {};
  }
  return Primitive{.shape = Box{.size = size}, .offset = centred ? glm::dvec3(0.0) : 0.5 * size};
}

std::optional<Primitive> PrimitiveMaker::sphere(const Node& node) {
  const Parameters parameters(file_, node, {"r"}, {"d"}, warnings_);
  const double radius = parameters.find("d") != nullptr ? 0.5 * parameters.number("d", 2.0)
                                                        : parameters.number("r", 1.0);
  if (!(radius > 0.0)) {
    return {};
  }
  const std::uint32_t count = corners(parameters, radius);
  count_triangles(node, sphere_triangles(count));
  return Primitive{.shape = closed(node, facet_sphere(radius, count))};
}

std::optional<Primitive> PrimitiveMaker::cylinder(const Node& node) {
  const Parameters parameters(file_, node, {"h", "r1", "r2", "center"}, {"r", "d", "d1", "d2"},
                              warnings_);
  const auto radius = [&](std::string_view by_radius, std::string_view by_diameter,
                          double otherwise) {
    return parameters.find(by_diameter) != nullptr
               ? 0.5 * parameters.number(by_diameter, 2.0 * otherwise)
               : parameters.number(by_radius, otherwise);
  };
  const double both = radius("r", "d", 1.0);
  const double bottom = radius("r1", "d1", both);
  const double top = radius("r2", "d2", both);
  const double height = parameters.number("h", 1.0);
  const bool centred = parameters.flag("center", false);
  const double widest = std::max(bottom, top);
  if (!(height > 0.0 && bottom >= 0.0 && top >= 0.0 && widest > 0.0)) {
    return {};
  }
  const std::uint32_t count = corners(parameters, widest);
  count_triangles(node, cylinder_triangles(count));
  return Primitive{.shape = closed(node, facet_cylinder(height, bottom, top, count)),
                   .offset = {0.0, 0.0, centred ? -0.5 * height : 0.0}};
}

std::optional<Primitive> PrimitiveMaker::polyhedron(const Node& node) {
  const Parameters parameters(file_, node, {"points", "faces", "convexity"}, {"triangles"},
                              warnings_);
  const Vector& points = parameters.vector("points");
  const Vector& faces =
      parameters.vector(parameters.find("faces") == nullptr ? "triangles" : "faces");
  if (faces.empty()) {
    return {};
  }
  Facets facets;
  std::uint64_t triangles = 0;
  for (const Value& value : points) {
    facets.points.push_back(point(parameters, value, facets.points.size()));
  }
  for (const Value& value : faces) {
    facets.surface.push_back(static_cast<std::uint32_t>(facets.polygons.size()));
    facets.polygons.push_back(polygon(parameters, value, facets.polygons.size(), points.size()));
    triangles += facets.polygons.back().size();
  }
  count_triangles(node, triangles);
  return Primitive{.shape = closed(node, std::move(facets))};
}

std::uint32_t PrimitiveMaker::corners(const Parameters& parameters, double radius) const {
  const FacetRule rule{.number = parameters.number("$fn", facets_.number),
                       .angle = parameters.number("$fa", facets_.angle),
                       .size = parameters.number("$fs", facets_.size)};
  try {
    return facet_count(radius, rule);
  } catch (const std::length_error& error) {
    parameters.fail(error.what());
  }
}

void PrimitiveMaker::count_triangles(const Node& node, std::uint64_t triangles) {
  triangles_ += triangles;
  if (triangles_ > most_triangles) {
    throw LoadError(file_, line_place(node.line),
                    fmt::format("{}: .csg files hold at most {} triangles, but this makes it {}",
                                node.name, most_triangles, triangles_));
  }
}

Shape PrimitiveMaker::closed(const Node& node, Facets facets) const {
  try {
    TriangleMesh mesh = triangulate(std::move(facets.points), facets.polygons, facets.surface);
    if (signed_volume(mesh) < 0.0) {
      for (glm::uvec3& triangle : mesh.triangles) {
        std::swap(triangle.y, triangle.z);
      }
    }
    return std::make_shared<const ClosedMesh>(std::move(mesh));
  } catch (const std::invalid_argument& error) {
    throw LoadError(file_, line_place(node.line), fmt::format("{}: {}", node.name, error.what()));
  }
}

}  // namespace raycat::openscad
