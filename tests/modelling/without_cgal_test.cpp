#include <catch2/catch.hpp>

#include "modelling/convex_hull.hpp"
#include "modelling/evaluate.hpp"

namespace raycat {
namespace {

TEST_CASE("without CGAL, what needs it says so", "[modelling]") {
  const std::string message =
      "this raycat was built without CGAL, which makes hulls, extrusions and meshes of CSG";
  CHECK_THROWS_WITH(convex_hull({}), message);
  CHECK_THROWS_WITH(evaluate(CsgTree()), message);
}

}  // namespace
}  // namespace raycat
