#include "modelling/convex_parts.hpp"

#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_decomposition_3.h>

#include "modelling/convex_hull.hpp"
#include "modelling/nef.hpp"

namespace raycat {
namespace {

// Only rounding may keep the volumes of a convex body and of its hull apart.
bool is_convex(const TriangleMesh& mesh, const TriangleMesh& hull) {
  constexpr double rounding = 1e-9;
  return signed_volume(mesh) >= (1.0 - rounding) * signed_volume(hull);
}

}  // namespace

std::vector<std::vector<glm::dvec3>> convex_parts(const TriangleMesh& mesh) {
  const TriangleMesh hull = convex_hull(mesh.positions);
  if (is_convex(mesh, hull)) {
    return {hull.positions};
  }
  Nef nef = nef_of(mesh);
  CGAL::convex_decomposition_3(nef);
  std::vector<std::vector<glm::dvec3>> parts;
  for (auto part = ++nef.volumes_begin(); part != nef.volumes_end(); ++part) {  // past the outside
    if (!part->mark()) {
      continue;
    }
    CGAL::Polyhedron_3<Exact> convex;
    nef.convert_inner_shell_to_polyhedron(part->shells_begin(), convex);
    std::vector<glm::dvec3>& corners = parts.emplace_back();
    for (auto vertex = convex.vertices_begin(); vertex != convex.vertices_end(); ++vertex) {
      corners.push_back(rounded(vertex->point()));
    }
  }
  return parts;
}

}  // namespace raycat
