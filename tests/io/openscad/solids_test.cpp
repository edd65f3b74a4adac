#include <string>

#include <catch2/catch.hpp>

#include "tests/io/scene_text.hpp"
#include "tracer/srgb.hpp"

namespace raycat {
namespace {

std::string error_of(const std::string& text) { return load_error("a.csg", text); }
SceneFile load(const std::string& text) { return load_text("a.csg", text); }

// How much of the line along x at this y and z is inside of the scene.
double thickness(const SceneFile& file, double y = 0.1, double z = 0.2) {
  Solid::Scratch scratch;
  double sum = 0.0;
  for (const SolidObject& object : file.scene.solids) {
    object.solid.cross({.origin = {-100.0, y, z}, .direction = {1.0, 0.0, 0.0}}, scratch);
    for (const Boundary& boundary : scratch.boundaries) {
      sum += boundary.entering ? -boundary.t : boundary.t;
    }
  }
  return sum;
}

const std::string big = "cube(size = [4, 4, 4], center = true);";
const std::string small = "cube(size = [2, 2, 2], center = true);";
const std::string moved = "multmatrix([[1,0,0,1],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) {" + big + "}";

TEST_CASE("set operations mean what they say", "[io][openscad]") {
  CHECK(thickness(load("cube(size = [2, 2, 2], center = false);")) == 2.0);
  CHECK(thickness(load("union() {" + big + moved + "}")) == 5.0);
  CHECK(thickness(load("intersection() {" + big + moved + "}")) == 3.0);
  CHECK(thickness(load("difference() {" + big + moved + "}")) == 1.0);
  CHECK(thickness(load("difference() {" + big + small + moved + "}")) == 1.0);
  CHECK(thickness(load("difference() {" + big + "difference() {" + moved + small + "} }")) == 3.0);
  CHECK(thickness(load("intersection() {" + big + "}")) == 4.0);
  CHECK(thickness(load("difference() {" + big + "}")) == 4.0);
  CHECK(thickness(load("intersection() { group() {" + small + moved + "}" + big + "}")) == 3.0);
}

TEST_CASE("empty operands follow OpenSCAD's rules", "[io][openscad]") {
  const std::string nothing = "cube(size = [0, 1, 1], center = false);";
  CHECK(load("difference() { group();" + big + "}").scene.solids.empty());
  CHECK(load("difference() {" + nothing + big + "}").scene.solids.empty());
  CHECK(load("intersection() {" + big + "group(); }").scene.solids.empty());
  CHECK(load("intersection() {" + big + nothing + "}").scene.solids.empty());
  CHECK(thickness(load("difference() {" + big + "group();" + nothing + "}")) == 4.0);
  CHECK(thickness(load("union() { group();" + big + "}")) == 4.0);
  CHECK(load("group();").warnings == std::vector<std::string>{"the file holds no solid"});
}

TEST_CASE("modifiers leave out, keep or single out a node", "[io][openscad]") {
  CHECK(thickness(load("difference() { %" + small + big + moved + "}")) == 1.0);
  CHECK(thickness(load("difference() { *" + small + big + moved + "}")) == 1.0);
  CHECK(thickness(load("difference() { #" + big + "#" + moved + "}")) == 1.0);
  CHECK(thickness(load("difference() {" + big + "!" + small + "}")) == 2.0);
  CHECK(thickness(load("%linear_extrude(height = 1) { square(1); }" + big)) == 4.0);
}

TEST_CASE("the first operand says whether an operation is in two dimensions", "[io][openscad]") {
  const std::string square = "square(size = [1, 1], center = false);";
  const SceneFile ignored = load("union() {" + big + "\n" + square + "}");
  CHECK(thickness(ignored) == 4.0);
  CHECK(ignored.warnings ==
        std::vector<std::string>{
            "line 2: square: is two-dimensional and ignored in three dimensions"});
  CHECK(thickness(load("difference() {" + big + square + small + "}")) == 2.0);
  CHECK(load("union() {" + square + big + "}").scene.solids.empty());
}

TEST_CASE("multmatrix is row-major and divided by its last number", "[io][openscad]") {
  const std::string halved = "multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,2]]) {" + big + "}";
  CHECK(thickness(load(halved)) == 2.0);
  const SceneFile flat =
      load("multmatrix([[1,0,0,0],[0,1,0,0],[0,0,0,0],[0,0,0,1]]) {" + big + "}" + small);
  CHECK(thickness(flat) == 2.0);
  CHECK(flat.warnings.at(0) == "line 1: multmatrix: is singular, so its children have no volume");
  CHECK(error_of("multmatrix([[1,0,0,0]]) { }") ==
        "a.csg: line 1: multmatrix: m must be 4 rows of 4 numbers");
}

TEST_CASE("unknown numbers give a parameter its default", "[io][openscad]") {
  CHECK(thickness(load("cube(size = nan, center = true);")) == 1.0);
  CHECK(thickness(load("cube(size = [5, inf, 7], center = true);"), 0.1, 0.2) == 5.0);
  CHECK(thickness(load("cube(size = [5, inf, 7], center = true);"), 0.1, 0.6) == 0.0);
  CHECK(thickness(load("cube(3);")) == 3.0);
}

TEST_CASE("top-level solids that do not touch are objects of their own", "[io][openscad]") {
  const auto at = [](const std::string& x) {
    return "multmatrix([[1,0,0," + x + "],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) {\n" + small + "}";
  };
  const SceneFile file = load("group() {" + at("0") + "union() {" + at("2") + at("9") + "}}");
  REQUIRE(file.scene.solids.size() == 2);
  const SurfaceTable& surfaces = file.scene.surfaces;
  CHECK(surfaces.name(ObjectId{0}) == "cube line 2");
  CHECK(surfaces.name(ObjectId{1}) == "cube line 4");
  CHECK(surfaces.primitives() == 3);
  CHECK(surfaces.faces() == 18);
  CHECK(file.csg_nodes == 3);
  CHECK(thickness(file) == 6.0);
  CHECK(file.up == glm::dvec3(0.0, 0.0, 1.0));
  CHECK(load("cube();sphere(5);cube();").scene.surfaces.name(PrimitiveId{2}) == "cube line 1 (2)");
}

TEST_CASE("facets of one surface are one face", "[io][openscad]") {
  const auto faces = [](const std::string& text) { return load(text).scene.surfaces.faces(); };
  CHECK(faces("sphere(r = 10);") == 1);
  CHECK(faces("cylinder(h = 1, r1 = 1, r2 = 1);") == 3);
  CHECK(faces("cylinder(h = 1, r1 = 1, r2 = 0);") == 2);
  CHECK(faces("cube();") == 6);
  CHECK(faces("polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], "
              "faces = [[0,1,2],[0,3,1],[1,3,2],[0,2,3]]);") == 4);
}

TEST_CASE("polyhedra are closed and turned the right way", "[io][openscad]") {
  const std::string points = "polyhedron(points = [[0,0,0],[4,0,0],[0,4,0],[0,0,4]], faces = ";
  const double right = thickness(load(points + "[[0,1,2],[0,3,1],[1,3,2],[0,2,3]]);"));
  CHECK(right == Approx(3.7));
  CHECK(thickness(load(points + "[[2,1,0],[1,3,0],[2,3,1],[3,2,0]]);")) == Approx(right));
  CHECK(error_of("\n" + points + "[[0,1,2],[0,3,1],[1,3,2]]);")
            .starts_with("a.csg: line 2: polyhedron: "));
  CHECK(error_of(points + "[[0,1,2],[0,3,9]]);") ==
        "a.csg: line 1: polyhedron: face 1 has point 9, but there are 4 points");
  CHECK(error_of(points + "[[0,1,0.5]]);") ==
        "a.csg: line 1: polyhedron: face 0 must be a vector of point numbers");
  CHECK(error_of("polyhedron(points = [[1, 2]], faces = [[0, 0, 0]]);") ==
        "a.csg: line 1: polyhedron: point 0 must be [x, y, z]");
  CHECK(error_of("polyhedron(points = 5);") ==
        "a.csg: line 1: polyhedron: points must be a vector");
}

TEST_CASE("the outermost colour that is set wins", "[io][openscad]") {
  const auto diffuse = [](const std::string& text) {
    const SceneFile file = load(text);
    const SolidObject& object = file.scene.solids.at(0);
    return file.scene.materials.at(static_cast<std::size_t>(object.materials.back())).diffuse;
  };
  const glm::vec3 red(1.0f, 0.0f, 0.0f);
  const glm::vec3 blue(0.0f, 0.0f, 1.0f);
  CHECK(diffuse("color([1, 0, 0, 1]) { color([0, 0, 1, 1]) { cube(); } }") == red);
  CHECK(diffuse("color([-1, -1, -1, 1]) { color([0, 0, 1, 1]) { cube(); } }") == blue);
  CHECK(diffuse("cube();").r == linear_from_srgb(249.0f / 255.0f));
  CHECK(diffuse("difference() {" + big + moved + "}").r == linear_from_srgb(157.0f / 255.0f));
  CHECK(diffuse("difference() {" + big + "color([1, 0, 0, 1]) {" + moved + "} }") == red);
}

TEST_CASE("view variables are the camera, as OpenSCAD looks", "[io][openscad]") {
  CHECK(load(big).scene.cameras.empty());
  const SceneFile top = load("$vpt = [1, 2, 3]; $vpr = [0, 0, 0]; $vpd = 10;" + big);
  REQUIRE(top.scene.cameras.size() == 1);
  CHECK(top.scene.cameras[0].eye == glm::dvec3(1.0, 2.0, 13.0));
  CHECK(top.scene.cameras[0].forward == glm::dvec3(0.0, 0.0, -1.0));
  CHECK(top.scene.cameras[0].up == glm::dvec3(0.0, 1.0, 0.0));
  CHECK(top.scene.cameras[0].half_height == Approx(0.198912));  // tan(22.5 degrees / 2)
  const SceneFile front = load("$vpr = [90, 0, 90]; $vpd = 10; $vpf = 90;" + big);
  const Camera& camera = front.scene.cameras.at(0);
  CHECK(camera.eye.x == Approx(10.0));
  CHECK(camera.up.z == Approx(1.0));
  CHECK(camera.right.y == Approx(1.0));
  CHECK(camera.half_height == Approx(1.0));
  CHECK(error_of("$vpf = 180;" + big) ==
        "a.csg: line 1: $vpf must be a number above 0 and below 180");
}

TEST_CASE("what cannot be made is named with its line", "[io][openscad]") {
  CHECK(error_of("group() {\n roof() { square(1); } }") == "a.csg: line 2: roof: is not supported");
  CHECK(error_of("translate([1, 2, 3]) { cube(); }") == "a.csg: line 1: translate: unknown node");
  CHECK(error_of("cube(size = \"a\");") ==
        "a.csg: line 1: cube: size must be a number or [x, y, z]");
  CHECK(error_of("sphere($fn = 1e7);") ==
        "a.csg: line 1: sphere: circles have at most 1000000 corners, but this has 1e+07");
  CHECK(error_of("sphere($fn = 9999);") ==
        "a.csg: line 1: sphere: .csg files hold at most 20000000 triangles, but this makes it "
        "99990000");
  CHECK(error_of("cube(1e200);") ==
        "a.csg: line 1: cube: coordinates are at most 1e+50, but this reaches 1e+200");
  CHECK(load("cube(foo = 1, size = 2);").warnings ==
        std::vector<std::string>{"line 1: cube: the unknown parameter foo is ignored"});
}

}  // namespace
}  // namespace raycat
