#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "modelling/extrusion.hpp"
#include "tests/modelling/openscad_oracle.hpp"

namespace raycat {
namespace {

struct Outline {
  std::string csg;
  Polygons polygons;
};

Contour rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

std::vector<Outline> outlines() {
  const Contour triangle{{1, 0}, {5, 1}, {2, 4}};
  const Contour ring{{-3, -3}, {4, -3}, {4, 4}, {-3, 4}};
  const Contour hole{{-1, -1}, {-1, 1}, {1, 1}, {1, -1}};
  const Contour arrow{{0, 0}, {6, -2}, {2, 0}, {6, 2}};
  return {
      {"square(size=[10,10],center=false);", {{rectangle(0, 0, 10, 10)}}},
      {"square(size=[4,6],center=true);", {{rectangle(-2, -3, 2, 3)}}},
      {"polygon(points=[[1,0],[5,1],[2,4]],paths=undef,convexity=1);", {{triangle}}},
      {"polygon(points=[[0,0],[6,-2],[2,0],[6,2]],paths=undef,convexity=1);", {{arrow}}},
      {"difference(){polygon(points=[[-3,-3],[4,-3],[4,4],[-3,4]],paths=undef,convexity=1);"
       "square(size=[2,2],center=true);}",
       {{ring, hole}}},
  };
}

TEST_CASE("linear extrusions are OpenSCAD's", "[modelling][extrusion][openscad]") {
  if (!openscad_is_installed()) {
    return;
  }
  struct Case {
    double twist;
    glm::dvec2 scale;
    FacetRule rule;
    std::uint32_t slices;
  };
  std::vector<Case> cases;
  for (const double twist : {0.0, 20.0, 90.0, -90.0, 400.0, -250.0}) {
    for (const glm::dvec2 scale :
         {glm::dvec2(1, 1), glm::dvec2(2, 2), glm::dvec2(0.5, 0.5), glm::dvec2(1, 2),
          glm::dvec2(2, 0.5), glm::dvec2(0, 1), glm::dvec2(0, 0)}) {
      cases.push_back({twist, scale, {}, 0});
      cases.push_back({twist, scale, {.number = 7}, 0});
      cases.push_back({twist, scale, {.angle = 7, .size = 1.3}, 0});
      cases.push_back({twist, scale, {}, 5});
    }
  }
  const std::vector<Outline> shapes = outlines();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Case& c = cases[i];
    const Outline& outline = shapes[(i + i / 4) % shapes.size()];
    LinearExtrusion extrusion{.height = 7.0, .twist = c.twist, .scale = c.scale};
    extrusion.slices =
        c.slices > 0 ? c.slices : default_slices(outline.polygons, extrusion, c.rule);
    const std::string csg = fmt::format(
        "linear_extrude(height=7,center=false,twist={},scale=[{},{}],{}$fn={},$fa={},$fs={}){{{}}}",
        c.twist, c.scale.x, c.scale.y, c.slices > 0 ? fmt::format("slices={},", c.slices) : "",
        c.rule.number, c.rule.angle, c.rule.size, outline.csg);
    INFO(csg);
    // The volume knows every diagonal.
    CHECK(volume(linear_extrusion(outline.polygons, extrusion)) ==
          Approx(volume(openscad_mesh(csg))).epsilon(1e-5));
  }
}

TEST_CASE("rotate extrusions are OpenSCAD's", "[modelling][extrusion][openscad]") {
  if (!openscad_is_installed()) {
    return;
  }
  const std::vector<Outline> shapes = outlines();
  std::size_t next = 0;
  for (const double shift : {5.0, 0.0, -12.0, 0.5}) {
    for (const double angle : {360.0, 90.0, -90.0, 400.0, -720.0, 359.0, -1.0, 200.0}) {
      for (const FacetRule rule :
           {FacetRule{}, FacetRule{.number = 7}, FacetRule{.angle = 5, .size = 0.3}}) {
        const Outline& outline = shapes[next++ % shapes.size()];
        const Polygons profile = transformed(outline.polygons, {{1, 0}, {0, 1}, {shift, 0}});
        const std::string csg = fmt::format(
            "rotate_extrude(angle={},convexity=2,$fn={},$fa={},$fs={}){{"
            "multmatrix([[1,0,0,{}],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){{{}}}}}",
            angle, rule.number, rule.angle, rule.size, shift, outline.csg);
        INFO(csg);
        TriangleMesh mesh;
        try {
          mesh = rotate_extrusion(
              profile, {.angle = angle, .fragments = default_fragments(profile, angle, rule)});
        } catch (const std::invalid_argument&) {
          CHECK_THROWS(openscad_mesh(csg));
          continue;
        }
        const TriangleMesh reference = openscad_mesh(csg);
        CHECK(volume(mesh) == Approx(volume(reference)).epsilon(1e-5));
        CHECK(compare(ClosedMesh(mesh), ClosedMesh(reference)).bad == 0);
      }
    }
  }
}

}  // namespace
}  // namespace raycat
