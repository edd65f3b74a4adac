#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "modelling/extrusion.hpp"
#include "modelling/offset.hpp"
#include "modelling/polygons.hpp"
#include "modelling/projection.hpp"
#include "tests/modelling/openscad_oracle.hpp"
#include "tests/modelling/sample_contours.hpp"

namespace raycat {
namespace {

// One that does not cross itself, star-shaped about the origin.
Contour random_star(std::mt19937& random, int corners, double size) {
  std::uniform_real_distribution<double> share(0.2, 1.0);
  Contour out;
  for (int i = 0; i < corners; ++i) {
    const glm::dvec2 p = size * share(random) * unit_vector(360.0 * i / corners);
    out.emplace_back(std::round(p.x * 16) / 16, std::round(p.y * 16) / 16);
  }
  return out;
}

std::string polygon_csg(const std::vector<Contour>& contours) {
  std::string points;
  std::string paths;
  int corner = 0;
  for (const Contour& contour : contours) {
    std::string path;
    for (const glm::dvec2& p : contour) {
      points += fmt::format("{}[{},{}]", points.empty() ? "" : ",", p.x, p.y);
      path += fmt::format("{}{}", path.empty() ? "" : ",", corner++);
    }
    paths += fmt::format("{}[{}]", paths.empty() ? "" : ",", path);
  }
  return fmt::format("polygon(points=[{}],paths=[{}],convexity=1);", points, paths);
}

void check_is(const Polygons& polygons, const std::string& csg) {
  INFO(csg);
  const TriangleMesh reference =
      openscad_mesh("linear_extrude(height=3,center=false){" + csg + "}");
  const TriangleMesh mesh = linear_extrusion(polygons, {.height = 3.0});
  CHECK(volume(mesh) == Approx(volume(reference)).epsilon(1e-3));
  CHECK(compare(ClosedMesh(mesh), ClosedMesh(reference)).bad == 0);
}

// As face 1, all others being face 0.
void mark_faces_in_plane(TriangleMesh& mesh) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[i];
    mesh.faces[i] =
        mesh.positions[t.x].z == 0.0 && mesh.positions[t.y].z == 0.0 && mesh.positions[t.z].z == 0.0
            ? 1
            : 0;
  }
  mesh.face_count = 2;
}

TEST_CASE("polygons that cross themselves are OpenSCAD's", "[modelling][polygons][openscad]") {
  if (!openscad_is_installed()) {
    return;
  }
  std::mt19937 random(13);
  for (int i = 0; i < 12; ++i) {
    std::vector<Contour> contours;
    for (int k = 0; k <= i % 3; ++k) {
      contours.push_back(random_contour(random, 3 + i % 6, 20.0));
    }
    check_is(even_odd(contours), polygon_csg(contours));
  }
}

TEST_CASE("set operations on polygons are OpenSCAD's", "[modelling][polygons][openscad]") {
  if (!openscad_is_installed()) {
    return;
  }
  std::mt19937 random(4);
  for (int i = 0; i < 6; ++i) {
    std::vector<Polygons> operands;
    std::string csg;
    for (int k = 0; k < 3; ++k) {
      const std::vector<Contour> contours{random_contour(random, 5, 20.0)};
      operands.push_back(even_odd(contours));
      csg += polygon_csg(contours);
    }
    check_is(combined(Operation::set_union, operands), "union(){" + csg + "}");
    check_is(combined(Operation::difference, operands), "difference(){" + csg + "}");
    const std::span<const Polygons> two(operands.data(), 2);
    check_is(combined(Operation::intersection, two),
             "intersection(){" + csg.substr(0, csg.rfind("polygon")) + "}");
    check_is(hull(operands), "hull(){" + csg + "}");
  }
}

TEST_CASE("offsets are OpenSCAD's", "[modelling][offset][openscad]") {
  if (!openscad_is_installed()) {
    return;
  }
  std::mt19937 random(5);
  for (int i = 0; i < 8; ++i) {
    const std::vector<Contour> contours{random_star(random, 5 + i, 20.0)};
    const Polygons star = even_odd(contours);
    for (const double distance : {3.0, -1.25, 0.5}) {
      for (const FacetRule rule : {FacetRule{}, FacetRule{.number = 8}, FacetRule{.number = 37}}) {
        const std::uint32_t facets = facet_count(std::abs(distance), rule);
        check_is(offset(star, distance, Join::round, facets),
                 fmt::format("offset(r={},$fn={},$fa=12,$fs=2){{{}}}", distance, rule.number,
                             polygon_csg(contours)));
      }
      check_is(offset(star, distance, Join::mitre, 3),
               fmt::format("offset(delta={},chamfer=false,$fn=0,$fa=12,$fs=2){{{}}}", distance,
                           polygon_csg(contours)));
      check_is(offset(star, distance, Join::chamfer, 3),
               fmt::format("offset(delta={},chamfer=true,$fn=0,$fa=12,$fs=2){{{}}}", distance,
                           polygon_csg(contours)));
    }
  }
}

TEST_CASE("Minkowski sums in the plane are OpenSCAD's", "[modelling][polygons][openscad]") {
  if (!openscad_is_installed()) {
    return;
  }
  std::mt19937 random(6);
  for (int i = 0; i < 8; ++i) {
    const std::vector<Contour> a{random_star(random, 5 + i, 20.0), random_star(random, 7, 3.0)};
    const std::vector<Contour> b{random_star(random, 3 + i, 4.0)};
    check_is(minkowski_sum(even_odd(a), even_odd(b)),
             "minkowski(convexity=0){" + polygon_csg(a) + polygon_csg(b) + "}");
  }
}

TEST_CASE("projections are OpenSCAD's", "[modelling][projection][openscad]") {
  if (!openscad_is_installed()) {
    return;
  }
  const std::string sphere = "sphere($fn=0,$fa=12,$fs=2,r=10);";
  const std::string cube = "cube(size=[7,8,9],center=false);";
  const std::string low = "multmatrix([[1,0,0,3],[0,1,0,-4],[0,0,1,-9],[0,0,0,1]]){" + cube + "}";
  const std::string through =
      "multmatrix([[1,0,0,-2],[0,1,0,5],[0,0,1,-4],[0,0,0,1]]){" + cube + "}";
  const std::string tilted =
      "multmatrix([[0.8,0,0.6,1],[0.36,0.8,-0.48,2],[-0.48,0.6,0.64,-3],[0,0,0,1]]){"
      "difference(){cube(size=[20,20,20],center=true);cylinder($fn=9,h=50,r1=5,r2=3,center=true);}"
      "}";
  const std::string pit =
      "difference(){multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,-5],[0,0,0,1]]){"
      "cube(size=[20,20,10],center=false);}multmatrix([[1,0,0,5],[0,1,0,5],"
      "[0,0,1,0],[0,0,0,1]]){cube(size=[4,6,20],center=false);}}";
  const std::string hollow = "difference(){cube(size=[20,20,20],center=true);" + sphere + "}";
  for (const std::string& solid :
       {sphere, cube, low, through, tilted, pit, hollow, cube + low, low + through}) {
    TriangleMesh mesh = openscad_mesh("union(){" + solid + "}");
    mark_faces_in_plane(mesh);
    check_is(section(mesh, {false, solid == pit}),
             "projection(cut=true,convexity=0){union(){" + solid + "}}");
    check_is(shadow(mesh), "projection(cut=false,convexity=0){union(){" + solid + "}}");
  }
}

}  // namespace
}  // namespace raycat
