// Nodes that make shapes of their operands, against lengths worked out by hand.

#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include "io/load_scene.hpp"
#include "tests/io/scene_text.hpp"

namespace raycat {
namespace {

SceneFile load(const std::string& text) { return load_text("a.csg", text); }
std::string error_of(const std::string& text) { return load_error("a.csg", text); }

std::string moved(const std::string& by, const std::string& what) {
  return "multmatrix([[1,0,0," + by + "],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) {" + what + "}";
}

// How much of the line along an axis through `at` is inside of the scene.
double thickness(const SceneFile& file, int axis, glm::dvec3 at) {
  Solid::Scratch scratch;
  glm::dvec3 direction(0.0);
  direction[axis] = 1.0;
  at[axis] = -100.0;
  double sum = 0.0;
  for (const SolidObject& object : file.scene.solids) {
    object.solid.cross({.origin = at, .direction = direction}, scratch);
    for (const Boundary& boundary : scratch.boundaries) {
      sum += boundary.entering ? -boundary.t : boundary.t;
    }
  }
  return sum;
}

double along_x(const std::string& text, double y = 0.1, double z = 0.2) {
  return thickness(load(text), 0, {0.0, y, z});
}

const std::string square = "square(size = [2, 3], center = false);";
const std::string cube = "cube(size = [2, 2, 2], center = false);";

TEST_CASE("shapes in the plane are extruded", "[io][openscad]") {
  CHECK(along_x("linear_extrude(height = 5) {" + square + "}") == 2.0);
  CHECK(thickness(load("linear_extrude(height = 5) {" + square + "}"), 2, {1, 1, 0}) == 5.0);
  CHECK(thickness(load("linear_extrude() {" + square + "}"), 2, {1, 1, 0}) == 100.0);
  const SceneFile centred = load("linear_extrude(height = 5, center = true) {" + square + "}");
  CHECK(bounds(centred.scene).min.z == -2.5);
  CHECK(load("linear_extrude(height = -5) {" + square + "}").scene.solids.empty());
  CHECK(load("linear_extrude(height = 5) { group(); }").scene.solids.empty());
  CHECK(along_x("linear_extrude(height = 4, scale = [0.5, 1]) {" + square + "}", 1.0, 2.0) ==
        Approx(1.5));
  // A slanting way keeps the section and moves it.
  const SceneFile slanting = load("linear_extrude(v = [3, 0, 4]) {" + square + "}");
  CHECK(thickness(slanting, 0, {0, 1, 2}) == Approx(2.0));
  CHECK(bounds(slanting.scene).max.x == Approx(5.0));
}

TEST_CASE("a ring turned round the axis is hollow", "[io][openscad]") {
  const std::string ring =
      "rotate_extrude($fn = 4) {" + moved("3", "square(size = [1, 2], center = false);") + "}";
  CHECK(along_x(ring, 0.0, 1.0) == Approx(2.0));
  const std::string half = "rotate_extrude(angle = 180, $fn = 4) {" +
                           moved("3", "square(size = [1, 2], center = false);") + "}";
  CHECK(thickness(load(half), 1, {0.0, 0.0, 1.0}) == Approx(1.0));
  CHECK(error_of("rotate_extrude() { square(size = [2, 2], center = true); }")
            .starts_with("a.csg: line 1: rotate_extrude: "));
}

TEST_CASE("set operations in the plane mean what they say", "[io][openscad]") {
  const auto extruded = [](const std::string& what) {
    return along_x("linear_extrude(height = 1) {" + what + "}", 0.5);
  };
  CHECK(extruded("union() {" + square + moved("1", square) + "}") == 3.0);
  CHECK(extruded("intersection() {" + square + moved("1", square) + "}") == 1.0);
  CHECK(extruded("difference() {" + square + moved("1", square) + "}") == 1.0);
  CHECK(extruded("difference() { group();" + square + "}") == 0.0);
  CHECK(extruded("intersection() {" + square + "group(); }") == 0.0);
  CHECK(extruded(square + moved("5", square)) == 4.0);
  CHECK(extruded("hull() {" + square + moved("5", square) + "}") == 7.0);
  CHECK(extruded("minkowski() {" + square + square + "}") == 4.0);
  CHECK(extruded("resize(newsize = [6, 0]) {" + square + "}") == 6.0);
  CHECK(extruded("resize(newsize = [0, 6], auto = [true, false]) {" + square + "}") == 4.0);
  CHECK(extruded("offset(delta = 1) {" + square + "}") == Approx(4.0));
  CHECK(along_x("linear_extrude(height = 1) { offset(r = -0.5) {" + square + "} }", 0.4) == 0.0);
  CHECK(along_x("linear_extrude(height = 1) { offset(r = -0.5) {" + square + "} }", 1.5) ==
        Approx(1.0));
  const std::string hole = "difference() { square(4, center = true); square(2, center = true); }";
  CHECK(extruded(hole) == 2.0);
  CHECK(extruded("fill() {" + hole + "}") == 4.0);
}

TEST_CASE("multmatrix moves, turns and flattens in the plane", "[io][openscad]") {
  const auto mapped = [](const std::string& rows) {
    return load("linear_extrude(height = 1) { multmatrix(" + rows + ") {" + square + "} }");
  };
  CHECK(thickness(mapped("[[0,-1,0,0],[1,0,0,0],[0,0,0,0],[0,0,0,1]]"), 0, {0, 1, 0.5}) == 3.0);
  CHECK(thickness(mapped("[[-1,0,0,0],[0,1,0,0],[0,0,1,9],[0,0,0,1]]"), 0, {0, 1, 0.5}) == 2.0);
  const SceneFile flat = mapped("[[0,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]");
  CHECK(flat.scene.solids.empty());
  CHECK(flat.warnings.at(0) == "line 1: multmatrix: is singular, so its children have no area");
}

TEST_CASE("polygons have holes by even and odd", "[io][openscad]") {
  const std::string text =
      "linear_extrude(height = 1) { polygon(points = [[0,0],[4,0],[4,4],[0,4],[1,1],[3,1],[3,3],"
      "[1,3]], paths = [[0,1,2,3],[4,5,6,7]], convexity = 1); }";
  CHECK(along_x(text, 2.0) == 2.0);
  CHECK(along_x(text, 0.5) == 4.0);
  CHECK(error_of("polygon(points = [[0, 0], [1, 0], [0, 1]], paths = [[0, 1, 3]]);") ==
        "a.csg: line 1: polygon: path 0 must be a vector of numbers of the 3 points");
  CHECK(error_of("polygon(points = [[0]]);") == "a.csg: line 1: polygon: point 0 must be [x, y]");
}

TEST_CASE("hulls and sums of solids", "[io][openscad]") {
  CHECK(along_x("hull() {" + cube + moved("5", cube) + "}") == 7.0);
  CHECK(along_x("hull() { group();" + cube + "}") == 2.0);
  CHECK(along_x("minkowski() {" + cube + moved("5", cube) + "}") == 4.0);
  CHECK(along_x("minkowski() { group() {" + cube + moved("5", cube) + "}" + cube + "}") == 8.0);
  CHECK(along_x("minkowski() {" + cube + "group(); }") == 2.0);
  // What is cut away does not count.
  CHECK(along_x("hull() { difference() {" + cube + moved("1", cube) + "} }") == 1.0);
  CHECK(load("hull() {" + cube + moved("5", cube) + "}").scene.surfaces.faces() == 6);
  // Sides that meet at 30 degrees, the crease, are faces, whichever way they are turned; those at
  // the two flat sides between meet at 15.
  const std::string twelve = "cylinder($fn = 12, h = 8, r1 = 10, r2 = 10);";
  for (const char* const turn :
       {"[1,0,0,0],[0,1,0,0],[0,0,1,0]", "[0.6,-0.8,0,0],[0.8,0.6,0,0],[0,0,1,0]",
        "[0.36,0.48,-0.8,0],[-0.8,0.6,0,0],[0.48,0.64,0.6,0]"}) {
    CAPTURE(turn);
    const std::string before = std::string("multmatrix([") + turn + ",[0,0,0,1]]) {";
    const std::string pair = before + twelve + "}" + before + moved("30", twelve) + "}";
    CHECK(load("hull() {" + pair + "}").scene.surfaces.faces() == 12);
  }
}

TEST_CASE("a sum keeps the hole that is larger than what is added", "[io][openscad]") {
  const std::string box =
      "minkowski() { difference() { cube(size = [9, 9, 9], center = true); "
      "cube(size = [5, 5, 5], center = true); } cube(size = [1, 1, 1], center = true); }";
  CHECK(along_x(box, 0.1, 0.2) == Approx(6.0));
  CHECK(along_x(box, 4.0, 0.2) == Approx(10.0));
}

TEST_CASE("resize stretches what is below it about the origin", "[io][openscad]") {
  const std::string at_one = moved("1", cube);
  CHECK(bounds(load("resize(newsize = [6, 0, 0]) {" + at_one + "}").scene).min.x == Approx(3.0));
  CHECK(along_x("resize(newsize = [6, 0, 0]) {" + at_one + "}") == Approx(6.0));
  CHECK(thickness(load("resize(newsize = [6, 0, 0], auto = true) {" + at_one + "}"), 2,
                  {4.0, 0.1, 0.0}) == Approx(6.0));
  // Of a difference it is the bounds of what is left that count.
  CHECK(along_x("resize(newsize = [6, 0, 0]) { difference() {" + cube + at_one + "} }") ==
        Approx(6.0));
  const std::string twice = "resize(newsize = [8, 0, 0]) { resize(newsize = [6, 6, 6]) {" + cube +
                            moved("4", cube) + "} }";
  CHECK(along_x(twice) == Approx(16.0 / 3.0));
  CHECK(load(twice).scene.surfaces.primitives() == 2);
}

TEST_CASE("projections are cuts and shadows", "[io][openscad]") {
  const std::string cone = "cylinder(h = 4, r1 = 2, r2 = 0, center = true, $fn = 4);";
  CHECK(along_x("linear_extrude(height = 1) { projection(cut = true) {" + cone + "} }", 0.0) ==
        Approx(2.0));
  CHECK(along_x("linear_extrude(height = 1) { projection(cut = false) {" + cone + "} }", 0.0) ==
        Approx(4.0));
}

TEST_CASE("smooth facets are true spheres, cylinders and cones", "[io][openscad]") {
  const TemporaryFile file("a.csg", "sphere(r = 2); " +
                                        moved("9", "cylinder(h = 4, r1 = 2, r2 = 1);") +
                                        moved("20", "cylinder(h = 4, r = 2, $fn = 6);"));
  const SceneFile scene = load_scene(file.path(), {.facets = Facetting::smooth});
  REQUIRE(scene.scene.solids.size() == 3);
  Solid::Scratch scratch;
  scene.scene.solids[0].solid.cross({.origin = {-9, 0, 1}, .direction = {1, 0, 0}}, scratch);
  CHECK(scratch.boundaries.at(0).t == Approx(9.0 - std::sqrt(3.0)));
  scene.scene.solids[1].solid.cross({.origin = {0, 0, 2}, .direction = {1, 0, 0}}, scratch);
  CHECK(scratch.boundaries.at(0).t == Approx(7.5));
  CHECK(std::holds_alternative<MeshShape>(
      scene.scene.solids[2].solid.tree().leaves()[0].shape.shape()));
}

TEST_CASE("with keep_going what cannot be made is left out with a warning", "[io][openscad]") {
  const TemporaryFile file("a.csg", "roof() { square(1); }\ncube(size = \"a\");\n" + cube);
  const SceneFile scene = load_scene(file.path(), {.keep_going = true});
  CHECK(scene.warnings ==
        std::vector<std::string>{"line 1: roof: is not supported; left out",
                                 "line 2: cube: size must be a number or [x, y, z]; left out"});
  CHECK(thickness(scene, 0, {0.0, 0.1, 0.2}) == 2.0);
}

TEST_CASE("meshes are imported from beside the file", "[io][openscad]") {
  const TemporaryFile mesh("part.off",
                           "OFF\n4 4 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n3 0 2 1\n3 0 1 3\n3 1 2 3\n"
                           "3 0 3 2\n");
  CHECK(along_x("difference() { cube(4); import(file = \"part.off\"); }") == Approx(4.0 - 3.7));
  CHECK(error_of("import(file = \"none.stl\");").starts_with("a.csg: line 1: import: "));
  CHECK(error_of("import(file = \"../part.off\");") ==
        "a.csg: line 1: import: file '../part.off' leads out of the file's folder");
  CHECK(error_of("import(file = \"part.dxf\");")
            .starts_with("a.csg: line 1: import: reads .stl, .off and .obj, not "));
}

}  // namespace
}  // namespace raycat
