#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

#include <glm/geometric.hpp>

#include "modelling/extrusion.hpp"
#include "modelling/smooth_runs.hpp"
#include "modelling/triangulation.hpp"

namespace raycat {
namespace {

// Where in a layer corners come to lie.
struct Layer {
  glm::dvec2 turned;  ///< the x axis, before scaling
  glm::dvec2 scale;
  double z;

  glm::dvec3 operator()(const glm::dvec2& p) const {
    const glm::dvec2 q(turned.x * p.x - turned.y * p.y, turned.y * p.x + turned.x * p.y);
    return {scale * q, z};
  }
};

std::vector<Layer> layers(const LinearExtrusion& extrusion) {
  std::vector<Layer> out;
  for (std::uint32_t i = 0; i <= extrusion.slices; ++i) {
    const double share = static_cast<double>(i) / extrusion.slices;
    out.push_back({.turned = unit_vector(-extrusion.twist * share),
                   .scale = (1.0 - share) + share * extrusion.scale,
                   .z = extrusion.z0 + share * extrusion.height});
  }
  return out;
}

// The four corners of a strip of wall between two layers, seen from outside.
struct Quad {
  std::uint32_t lower_left, lower_right, upper_right, upper_left;
};

// OpenSCAD cuts by the shorter diagonal, but by the longer one below a top that is a line. Of
// equal ones, as where the edge points at the axis of the twist, it takes that which leans
// against the turn of the layers.
bool rises_to_the_right(const TriangleMesh& mesh, const Quad& quad, bool clockwise, bool longer) {
  constexpr double equal = 1e-5;
  const auto length = [&](std::uint32_t a, std::uint32_t b) {
    return glm::distance(glm::dvec2(mesh.positions[a]), glm::dvec2(mesh.positions[b]));
  };
  const double rising = length(quad.lower_left, quad.upper_right);
  const double falling = length(quad.lower_right, quad.upper_left);
  if (2.0 * std::abs(rising - falling) > equal * (rising + falling)) {
    return (rising < falling) != longer;
  }
  return clockwise != longer;
}

void add_wall(const Quad& quad, bool rises, std::uint32_t face, TriangleMesh& mesh) {
  const auto& [a, b, c, d] = quad;
  mesh.triangles.emplace_back(a, b, rises ? c : d);
  mesh.triangles.emplace_back(rises ? a : b, c, d);
  mesh.faces.insert(mesh.faces.end(), 2, face);
}

void add_walls(const Polygons& polygons, const std::vector<Layer>& layers, bool clockwise,
               TriangleMesh& mesh) {
  const auto corners = static_cast<std::uint32_t>(mesh.positions.size() / layers.size());
  std::uint32_t first = 0;
  for (const Contour& contour : polygons.contours) {
    const auto n = static_cast<std::uint32_t>(contour.size());
    const std::vector<std::uint32_t> runs = smooth_runs(contour);
    for (std::uint32_t layer = 0; layer + 1 < layers.size(); ++layer) {
      const glm::dvec2& scale = layers[layer + 1].scale;
      const bool longer = (scale.x == 0.0) != (scale.y == 0.0);
      for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t left = layer * corners + first + i;
        const std::uint32_t right = layer * corners + first + (i + 1) % n;
        const Quad quad{left, right, right + corners, left + corners};
        add_wall(quad, rises_to_the_right(mesh, quad, clockwise, longer), mesh.face_count + runs[i],
                 mesh);
      }
    }
    first += n;
    mesh.face_count += 1 + *std::ranges::max_element(runs);
  }
}

}  // namespace

TriangleMesh linear_extrusion(const Polygons& polygons, const LinearExtrusion& extrusion) {
  const auto [outline, caps] = triangulated(polygons);
  TriangleMesh mesh;
  if (caps.empty()) {
    return mesh;
  }
  const std::vector<Layer> planes = layers(extrusion);
  for (const Layer& layer : planes) {
    for (const Contour& contour : outline.contours) {
      std::ranges::transform(contour, std::back_inserter(mesh.positions), layer);
    }
    if (mesh.positions.size() > std::numeric_limits<std::uint32_t>::max()) {
      throw std::length_error("a linear extrusion has 2^32 corners or more");
    }
  }
  // A top without area is a line or a point, of whose triangles the first kind still joins edges.
  const bool has_top = extrusion.scale.x != 0.0 && extrusion.scale.y != 0.0;
  const auto top =
      static_cast<std::uint32_t>(mesh.positions.size() / planes.size()) * extrusion.slices;
  for (const glm::uvec3& t : caps) {
    mesh.triangles.emplace_back(t.z, t.y, t.x);
    mesh.faces.push_back(0);
    mesh.triangles.push_back(top + t);
    mesh.faces.push_back(1);
  }
  mesh.face_count = has_top ? 2 : 1;
  add_walls(outline, planes, extrusion.twist >= 0.0, mesh);
  return mesh;
}

}  // namespace raycat
