#include "io/openscad/primitive.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>

#include "geometry/mesh.hpp"
#include "geometry/mesh_faces.hpp"
#include "io/openscad/parameters.hpp"

namespace raycat::openscad {

namespace {

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

// Up to here $fn says that a prism or a pyramid is meant, a hexagon nut say, and no round thing.
constexpr double most_meant_corners = 11.0;

bool is_round(const Context& context, const Parameters& parameters, Roundness roundness) {
  const double number = parameters.facets().number;
  return roundness == Roundness::as_asked && context.options.facets == Facetting::smooth &&
         !(number > 0.0 && number <= most_meant_corners);
}

glm::dmat4 moved(const glm::dvec3& by) { return glm::translate(glm::dmat4(1.0), by); }

// From the +Y axis that our shapes are around to +Z.
glm::dmat4 upright() {
  return {{1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 1.0, 0.0}, {0.0, -1.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 1.0}};
}

Shape closed_facets(const Node& node, Facets facets) {
  try {
    return closed(node, triangulate(std::move(facets.points), facets.polygons, facets.surface));
  } catch (const std::invalid_argument& error) {
    Context::fail(node, error.what());
  }
}

std::optional<Primitive> cube(Context& context, const Node& node) {
  const Parameters parameters(context, node, {"size", "center"}, {});
  const glm::dvec3 size = parameters.axes("size", 3, glm::dvec3(1.0));
  const bool centred = parameters.flag("center", false);
  if (!(size.x > 0.0 && size.y > 0.0 && size.z > 0.0)) {
    return {};
  }
  return Primitive{.shape = Box{.size = size},
                   .frame = moved(centred ? glm::dvec3(0.0) : 0.5 * size)};
}

std::optional<Primitive> sphere(Context& context, const Node& node, Roundness roundness) {
  const Parameters parameters(context, node, {"r"}, {"d"});
  const double radius = parameters.radius("r", "d", 1.0);
  if (!(radius > 0.0)) {
    return {};
  }
  if (is_round(context, parameters, roundness)) {
    return Primitive{.shape = Sphere{.radius = radius}};
  }
  const std::uint32_t count = parameters.corners(radius);
  context.count_triangles(node, sphere_triangles(count));
  return Primitive{.shape = closed_facets(node, facet_sphere(radius, count))};
}

std::optional<Primitive> cylinder(Context& context, const Node& node, Roundness roundness) {
  const Parameters parameters(context, node, {"h", "r1", "r2", "center"}, {"r", "d", "d1", "d2"});
  const double both = parameters.radius("r", "d", 1.0);
  const double bottom = parameters.radius("r1", "d1", both);
  const double top = parameters.radius("r2", "d2", both);
  const double height = parameters.number("h", 1.0);
  const bool centred = parameters.flag("center", false);
  const double widest = std::max(bottom, top);
  if (!(height > 0.0 && bottom >= 0.0 && top >= 0.0 && widest > 0.0)) {
    return {};
  }
  if (is_round(context, parameters, roundness)) {
    return Primitive{
        .shape = Cylinder{.height = height, .radius_top = top, .radius_bottom = bottom},
        .frame = moved({0.0, 0.0, centred ? 0.0 : 0.5 * height}) * upright()};
  }
  const std::uint32_t count = parameters.corners(widest);
  context.count_triangles(node, cylinder_triangles(count));
  return Primitive{.shape = closed_facets(node, facet_cylinder(height, bottom, top, count)),
                   .frame = moved({0.0, 0.0, centred ? -0.5 * height : 0.0})};
}

std::optional<Primitive> polyhedron(Context& context, const Node& node) {
  const Parameters parameters(context, node, {"points", "faces", "convexity"}, {"triangles"});
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
  context.count_triangles(node, triangles);
  return Primitive{.shape = closed_facets(node, std::move(facets))};
}

}  // namespace

std::optional<Primitive> solid_primitive(Context& context, const Node& node, Roundness roundness) {
  if (node.name == "cube") {
    return cube(context, node);
  }
  if (node.name == "sphere") {
    return sphere(context, node, roundness);
  }
  return node.name == "cylinder" ? cylinder(context, node, roundness) : polyhedron(context, node);
}

Shape closed(const Node& node, TriangleMesh mesh) {
  if (signed_volume(mesh) < 0.0) {
    for (glm::uvec3& triangle : mesh.triangles) {
      std::swap(triangle.y, triangle.z);
    }
  }
  try {
    return std::make_shared<const ClosedMesh>(std::move(mesh));
  } catch (const std::invalid_argument& error) {
    Context::fail(node, error.what());
  }
}

}  // namespace raycat::openscad
