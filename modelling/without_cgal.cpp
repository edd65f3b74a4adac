#include <stdexcept>

#include "modelling/convex_hull.hpp"
#include "modelling/evaluate.hpp"
#include "modelling/mesh_minkowski_sum.hpp"
#include "modelling/offset.hpp"
#include "modelling/polygons.hpp"
#include "modelling/projection.hpp"
#include "modelling/text_outline.hpp"
#include "modelling/triangulation.hpp"

namespace raycat {
namespace {

[[noreturn]] void refuse() {
  throw std::runtime_error(
      "this raycat was built without CGAL, which makes hulls, extrusions and meshes of CSG");
}

}  // namespace

TriangleMesh convex_hull(std::span<const glm::dvec3> /*points*/) { refuse(); }
TriangleMesh minkowski_sum(const TriangleMesh& /*a*/, const TriangleMesh& /*b*/) { refuse(); }
EvaluatedMesh evaluate(const CsgTree& /*tree*/, const TessellationRule& /*rule*/) { refuse(); }

Polygons even_odd(std::span<const Contour> /*contours*/) { refuse(); }
Polygons combined(Operation /*operation*/, std::span<const Polygons> /*operands*/) { refuse(); }
Polygons transformed(const Polygons& /*polygons*/, const glm::dmat3x2& /*map*/) { refuse(); }
Polygons hull(std::span<const Polygons> /*operands*/) { refuse(); }
Polygons minkowski_sum(const Polygons& /*a*/, const Polygons& /*b*/) { refuse(); }
Polygons filled(const Polygons& /*polygons*/) { refuse(); }
Polygons offset(const Polygons& /*polygons*/, double /*distance*/, Join /*join*/,
                std::uint32_t /*facets*/) {
  refuse();
}
Polygons section(const TriangleMesh& /*closed*/, const std::vector<bool>& /*open_faces*/) {
  refuse();
}
Polygons shadow(const TriangleMesh& /*closed*/) { refuse(); }
Polygons text_outline(const std::string& /*text*/, const TextStyle& /*style*/) { refuse(); }
Triangulation triangulated(Polygons /*polygons*/) { refuse(); }

}  // namespace raycat
