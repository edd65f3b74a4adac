#include <stdexcept>

#include "modelling/convex_hull.hpp"
#include "modelling/evaluate.hpp"

namespace raycat {
namespace {

[[noreturn]] void refuse() {
  throw std::runtime_error(
      "this raycat was built without CGAL, which makes hulls and meshes of CSG");
}

}  // namespace

TriangleMesh convex_hull(std::span<const glm::dvec3> /*points*/) { refuse(); }

EvaluatedMesh evaluate(const CsgTree& /*tree*/, const TessellationRule& /*rule*/) { refuse(); }

}  // namespace raycat
