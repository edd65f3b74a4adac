#include "io/gltf/shapes.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "tests/io/gltf/text.hpp"
#include "tracer/scene.hpp"

namespace raycat {
namespace {

// A document with a list of shapes and these nodes, and one triangle as meshes[0].
std::string physics(const std::string& list, const std::string& shapes, const std::string& roots,
                    const std::string& nodes) {
  return gltf(roots, nodes,
              R"(,"extensions":{")" + list + R"(":{"shapes":[)" + shapes +
                  R"(]}},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
          "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
          "bufferViews":[{"buffer":0,"byteLength":36}],)" +
                  buffer_of(floats({0, 0, 0, 1, 0, 0, 0, 1, 0})));
}

const std::string omi = R"("extensions":{"OMI_physics_body":{"collider":{"shape":0}}})";
const std::string khr =
    R"("extensions":{"KHR_physics_rigid_bodies":{"collider":{"geometry":{"shape":0}}}})";

TEST_CASE("shapes of physics are drawn where no mesh is", "[io][gltf][physics]") {
  const auto [list, body, shape, size] =
      GENERATE_COPY(table<std::string, std::string, std::string, glm::dvec3>(
          {{"OMI_physics_shape", omi, R"({"type":"sphere","sphere":{"radius":2}})", {4, 4, 4}},
           {"OMI_physics_shape", omi, R"({"type":"box","box":{"size":[1,2,3]}})", {1, 2, 3}},
           {"OMI_physics_shape", omi, R"({"type":"capsule"})", {1, 2, 1}},
           {"OMI_physics_shape", omi, R"({"type":"cylinder","cylinder":{}})", {1, 2, 1}},
           {"KHR_implicit_shapes", khr, R"({"type":"capsule","capsule":{}})", {0.5, 1, 0.5}},
           {"KHR_implicit_shapes", khr, R"({"type":"cylinder"})", {0.5, 0.5, 0.5}}}));
  const auto file =
      load_text("scene.gltf",
                physics(list, shape, "0", R"({"name":"it","translation":[5,0,0],)" + body + "}"));
  CHECK(file.warnings.empty());
  REQUIRE(file.scene.solids.size() == 1);
  CHECK(file.triangles == 0);
  CHECK(file.scene.surfaces.name(ObjectId{0}) == "it");
  const Bounds box = bounds(file.scene);
  CHECK(box.max.x - box.min.x == Approx(size.x));
  CHECK(box.max.y - box.min.y == Approx(size.y));
  CHECK(box.max.z - box.min.z == Approx(size.z));
  CHECK(box.center().x == Approx(5.0));
}

TEST_CASE("a mesh around stands for the shape of its body", "[io][gltf][physics]") {
  const std::string sphere = R"({"type":"sphere"})";
  const auto nodes = GENERATE(as<std::string>(),                        // roots are node 0
                              R"({"mesh":0,%},{})",                     // at the node
                              R"({"mesh":0,"children":[1]},{%})",       // above
                              R"({"children":[1],%},{"mesh":0})",       // below
                              R"({"children":[1,2]},{%},{"mesh":0})");  // beside
  std::string text = nodes;
  text.replace(text.find('%'), 1, omi);
  const auto file = load_text("scene.gltf", physics("OMI_physics_shape", sphere, "0", text));
  CHECK(file.scene.solids.empty());
  CHECK(file.triangles == 1);
}

TEST_CASE("shapes of triangles and planes with borders are not drawn", "[io][gltf][physics]") {
  for (const char* shape :
       {R"({"type":"convex","convex":{"mesh":0}})", R"({"type":"plane","plane":{"sizeX":2}})"}) {
    const auto file =
        load_text("scene.gltf", physics("KHR_implicit_shapes", shape, "0", "{" + khr + "}"));
    CHECK(file.scene.solids.empty());
    CHECK(file.warnings == std::vector<std::string>{"physics shapes are not drawn where meshes "
                                                    "are, nor without a closed form: 1"});
  }
}

TEST_CASE("shapes of physics that are wrong are refused", "[io][gltf][physics]") {
  const auto error = [](const std::string& shapes) {
    return gltf_error(physics("OMI_physics_shape", shapes, "0", "{" + omi + "}"));
  };
  CHECK(error("") == "OMI_physics_shape: there is no shapes[0]; the file has 0");
  CHECK(error(R"({"type":"sphere","sphere":{"radius":-1}})") ==
        "OMI_physics_shape: shapes[0]: sphere: radius must be a finite number above 0, but is -1");
  CHECK(error(R"({"box":{}})") == "OMI_physics_shape: shapes[0]: type is missing");
}

}  // namespace
}  // namespace raycat
