#include "io/openscad/made.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "geometry/mesh_faces.hpp"
#include "io/openscad/parameters.hpp"
#include "modelling/extrusion.hpp"
#include "modelling/offset.hpp"
#include "modelling/projection.hpp"

namespace raycat::openscad {

namespace {

// Of all the arcs of an offset.
constexpr std::uint64_t most_facets = 10'000'000;

std::uint64_t corners_of(const Polygons& polygons) {
  std::uint64_t corners = 0;
  for (const Contour& contour : polygons.contours) {
    corners += contour.size();
  }
  return corners;
}

// The way along which a node extrudes, of the length of its height.
glm::dvec3 way(const Parameters& parameters) {
  const double height = parameters.number("height", parameters.number("h", 100.0));
  if (parameters.find("v") == nullptr) {
    return {0.0, 0.0, height};
  }
  const glm::dvec3 v = parameters.axes("v", 3, glm::dvec3(0.0, 0.0, 1.0));
  if (!(glm::length(v) > 0.0)) {
    return glm::dvec3(0.0);
  }
  const bool has_height = parameters.find("height") != nullptr || parameters.find("h") != nullptr;
  return has_height ? height * glm::normalize(v) : v;
}

std::optional<Primitive> linear(Context& context, const Node& node, const Polygons& operand) {
  const Parameters parameters(context, node,
                              {"height", "v", "center", "convexity", "twist", "slices", "scale"},
                              {"h", "file", "layer", "origin", "segments"});
  if (parameters.find("file") != nullptr && !parameters.text("file", "").empty()) {
    parameters.fail("its file is not read; use import() below it");
  }
  const glm::dvec3 along = way(parameters);
  const glm::dvec2 scale = glm::max(parameters.axes("scale", 2, glm::dvec3(1.0)), 0.0);
  LinearExtrusion extrusion{.height = along.z,
                            .z0 = parameters.flag("center", false) ? -0.5 * along.z : 0.0,
                            .twist = parameters.number("twist", 0.0),
                            .scale = scale};
  if (!(along.z > 0.0) || operand.contours.empty()) {
    return {};
  }
  const double slices = parameters.number("slices", 0.0);
  try {
    extrusion.slices = slices >= 1.0 ? static_cast<std::uint32_t>(std::min(slices, 4e9))
                                     : default_slices(operand, extrusion, parameters.facets());
  } catch (const std::length_error& error) {
    parameters.fail(error.what());
  }
  context.require_triangles(node, 2 * corners_of(operand) * (std::uint64_t{extrusion.slices} + 1));
  std::optional<Primitive> made = solid(context, node, linear_extrusion(operand, extrusion));
  if (made) {
    made->frame[2] = glm::dvec4(along / along.z, 0.0);
  }
  return made;
}

std::optional<Primitive> rotated(Context& context, const Node& node, const Polygons& operand) {
  const Parameters parameters(context, node, {"angle", "start", "convexity"},
                              {"file", "layer", "origin", "scale"});
  const double angle = parameters.number("angle", 360.0);
  if (operand.contours.empty() || angle == 0.0) {
    return {};
  }
  RotateExtrusion extrusion{.angle = angle};
  try {
    extrusion.fragments = default_fragments(operand, angle, parameters.facets());
  } catch (const std::length_error& error) {
    parameters.fail(error.what());
  }
  context.require_triangles(node,
                            2 * corners_of(operand) * (std::uint64_t{extrusion.fragments} + 1));
  std::optional<Primitive> made = solid(context, node, rotate_extrusion(operand, extrusion));
  if (made && parameters.find("start") != nullptr) {
    const double full_start = std::abs(angle) >= 360.0 ? 180.0 : 0.0;
    made->frame = glm::rotate(glm::dmat4(1.0),
                              glm::radians(parameters.number("start", full_start) - full_start),
                              glm::dvec3(0.0, 0.0, 1.0));
  }
  return made;
}

// `r` rounds; `delta` does not, and by itself goes on until edges meet.
Polygons offset(Context& context, const Node& node, const Polygons& operand) {
  const Parameters parameters(context, node, {"r", "delta", "chamfer"},
                              {"join_type", "miter_limit"});
  const bool straight = parameters.find("delta") != nullptr;
  const double distance = straight ? parameters.number("delta", 1.0) : parameters.number("r", 1.0);
  const Join join = !straight                           ? Join::round
                    : parameters.flag("chamfer", false) ? Join::chamfer
                                                        : Join::mitre;
  const std::uint32_t facets = parameters.corners(std::abs(distance));
  if (join == Join::round &&
      facets > most_facets / std::max<std::uint64_t>(1, corners_of(operand))) {
    parameters.fail("takes too many corners");
  }
  return raycat::offset(operand, distance, join, facets);
}

}  // namespace

std::optional<Primitive> solid(Context& context, const Node& node, TriangleMesh mesh) {
  context.count_triangles(node, mesh.triangles.size());
  if (mesh.triangles.empty()) {
    return {};
  }
  return Primitive{.shape = closed(node, std::move(mesh))};
}

std::optional<Primitive> extruded(Context& context, const Node& node, const Polygons& operand) {
  return node.name == "linear_extrude" ? linear(context, node, operand)
                                       : rotated(context, node, operand);
}

Polygons flattened(Context& context, const Node& node, const Polygons& operand) {
  return node.name == "fill" ? filled(operand) : offset(context, node, operand);
}

Polygons projected(Context& context, const Node& node, const TriangleMesh& operand) {
  const Parameters parameters(context, node, {"cut", "convexity"}, {});
  return parameters.flag("cut", false) ? section(operand) : shadow(operand);
}

std::optional<Primitive> solid_with_faces(Context& context, const Node& node, TriangleMesh mesh) {
  mesh.faces = group_faces(mesh.positions, mesh.triangles, {}, context.options.faces,
                           context.options.threads)
                   .faces;
  mesh.face_count = mesh.faces.empty() ? 0 : 1 + *std::ranges::max_element(mesh.faces);
  return solid(context, node, std::move(mesh));
}

glm::dvec3 stretch(Context& context, const Node& node, const Bounds& box) {
  const Parameters parameters(context, node, {"newsize", "auto", "convexity"}, {});
  const std::size_t axes =
      parameters.find("newsize") != nullptr && parameters.find("newsize")->vector() != nullptr
          ? std::min<std::size_t>(parameters.vector("newsize").size(), 3)
          : 3;
  const glm::dvec3 wanted = parameters.axes("newsize", axes, glm::dvec3(0.0));
  glm::bvec3 automatic(false);
  if (const Value* const value = parameters.find("auto"); value != nullptr) {
    if (value->vector() == nullptr) {
      automatic = glm::bvec3(parameters.flag("auto", false));
    } else {
      for (std::size_t i = 0; i < std::min<std::size_t>(value->vector()->size(), 3); ++i) {
        const Value& one = (*value->vector())[i];
        const bool* const flag = std::get_if<bool>(&one.is);
        automatic[static_cast<int>(i)] =
            flag != nullptr ? *flag : one.number() != nullptr && *one.number() != 0.0;
      }
    }
  }
  const glm::dvec3 size = box.empty() ? glm::dvec3(0.0) : box.max - box.min;
  int most = 0;
  for (int axis = 1; axis < 3; ++axis) {
    most = wanted[axis] > wanted[most] ? axis : most;
  }
  // Axes without a size of their own go with the one that is stretched to the most.
  const double with = wanted[most] != 0.0 && size[most] > 0.0 ? wanted[most] / size[most] : 1.0;
  glm::dvec3 by(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    if (wanted[axis] != 0.0 && size[axis] > 0.0) {
      by[axis] = wanted[axis] / size[axis];
    } else if (wanted[axis] == 0.0 && automatic[axis]) {
      by[axis] = with;
    }
  }
  return by;
}

}  // namespace raycat::openscad
