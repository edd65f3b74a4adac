// Primitives of a mesh that continue each other, as exporters split what has too many vertices.

#include "io/gltf/primitive_faces.hpp"

#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "geometry/mesh.hpp"
#include "tests/io/gltf/text.hpp"

namespace raycat {
namespace {

// Writes meshes of quadrilaterals, each a primitive.
class Plates {
 public:
  // `attributes` and `more` go into the primitive.
  void add(std::initializer_list<float> corners, const std::string& more = "",
           const std::string& attributes = "") {
    primitives_ += fmt::format(R"({}{{"attributes":{{"POSITION":{}{}}},"indices":0{}}})",
                               primitives_.empty() ? "" : ",", vectors(corners), attributes, more);
  }

  // The number of an accessor of four vectors.
  std::size_t vectors(std::initializer_list<float> values) {
    accessors_ += fmt::format(
        R"(,{{"bufferView":0,"byteOffset":{},"componentType":5126,"count":4,"type":"VEC3"}})",
        bytes_.size());
    bytes_ += floats(values);
    return ++count_;
  }

  std::string document(const std::string& node = R"({"name":"plate","mesh":0})",
                       const std::string& more = "") const {
    // Two triangles of each quadrilateral.
    const std::string indices = le32(0) + le32(1) + le32(2) + le32(0) + le32(2) + le32(3);
    return gltf(
        "0", node,
        fmt::format(R"(,"meshes":[{{"primitives":[{}]}}],"accessors":[)"
                    R"({{"bufferView":1,"componentType":5125,"count":6,"type":"SCALAR"}}{}],)"
                    R"("bufferViews":[{{"buffer":0,"byteLength":{}}},)"
                    R"({{"buffer":0,"byteOffset":{},"byteLength":24}}],{}{})",
                    primitives_, accessors_, bytes_.size(), bytes_.size(),
                    buffer_of(bytes_ + indices), more));
  }

  SceneFile scene(const std::string& more = "", const LoadOptions& options = {}) const {
    return load_text("scene.gltf", document(R"({"name":"plate","mesh":0})", more), options);
  }

 private:
  std::string primitives_;
  std::string accessors_;
  std::string bytes_;
  std::size_t count_ = 0;
};

constexpr std::initializer_list<float> left{-1, -1, 0, 0, -1, 0, 0, 1, 0, -1, 1, 0};
constexpr std::initializer_list<float> right{0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0};
constexpr std::initializer_list<float> up{0, -1, 0, 0, -1, 1, 0, 1, 1, 0, 1, 0};
constexpr std::initializer_list<float> apart{5, -1, 0, 6, -1, 0, 6, 1, 0, 5, 1, 0};
const std::string materials = R"(,"materials":[{},{"alphaMode":"BLEND"}])";

std::vector<std::string> names(const SceneFile& file) {
  std::vector<std::string> out;
  for (std::uint32_t i = 0; i < file.scene.surfaces.primitives(); ++i) {
    out.push_back(file.scene.surfaces.name(PrimitiveId{i}));
  }
  return out;
}

// The face of the scene that each triangle of each primitive is of.
std::vector<std::uint32_t> faces(const SceneFile& file) {
  std::vector<std::uint32_t> out;
  for (const MeshInstance& instance : file.scene.meshes) {
    for (const std::uint32_t face : instance.mesh->triangles.faces) {
      out.push_back(static_cast<std::uint32_t>(instance.first_face) + face);
    }
  }
  return out;
}

using Names = std::vector<std::string>;
using Faces = std::vector<std::uint32_t>;

TEST_CASE("two primitives that continue each other are one", "[io][gltf][join]") {
  Plates plates;
  plates.add(left);
  plates.add(right);
  CHECK(names(plates.scene()) == Names{"plate"});
  CHECK(faces(plates.scene()) == Faces{0, 0, 0, 0});
  CHECK(plates.scene().scene.meshes.size() == 2);
  LoadOptions options;
  options.join_primitives = false;
  CHECK(names(plates.scene("", options)) == Names{"plate.0", "plate.1"});
  CHECK(faces(plates.scene("", options)) == Faces{0, 0, 1, 1});
}

TEST_CASE("joined primitives have the name of the first, and others keep theirs",
          "[io][gltf][join]") {
  Plates plates;
  plates.add(apart);
  plates.add(left);
  plates.add(up);
  plates.add(right);
  const SceneFile file = plates.scene();
  CHECK(names(file) == Names{"plate.0", "plate.1", "plate.2"});
  CHECK(faces(file) == Faces{0, 0, 1, 1, 2, 2, 1, 1});
}

TEST_CASE("primitives at an angle are one if their normals say so", "[io][gltf][join]") {
  const bool smooth = GENERATE(false, true);
  Plates plates;
  const float x = smooth ? -0.7F : 0.0F;  // of the normals at the common edge
  const float wall_x = smooth ? -0.7F : -1.0F;
  const std::size_t flat = plates.vectors({0, 0, 1, x, 0, 1 + x, x, 0, 1 + x, 0, 0, 1});
  const std::size_t wall =
      plates.vectors({wall_x, 0, 1 + wall_x, -1, 0, 0, -1, 0, 0, wall_x, 0, 1 + wall_x});
  plates.add(left, "", fmt::format(R"(,"NORMAL":{})", flat));
  plates.add(up, "", fmt::format(R"(,"NORMAL":{})", wall));
  CHECK(names(plates.scene()).size() == (smooth ? 1 : 2));
}

TEST_CASE("primitives of different materials stay apart", "[io][gltf][join]") {
  Plates plates;
  plates.add(left, R"(,"material":0)");
  plates.add(right, R"(,"material":1)");
  CHECK(faces(plates.scene(materials)) == Faces{0, 0, 1, 1});
}

TEST_CASE("a primitive with colours and one without stay apart", "[io][gltf][join]") {
  Plates plates;
  const std::size_t colours = plates.vectors({1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1});
  plates.add(left, "", fmt::format(R"(,"COLOR_0":{})", colours));
  plates.add(right);
  CHECK(faces(plates.scene()) == Faces{0, 0, 1, 1});
}

TEST_CASE("a primitive whose faces the file tells is not joined", "[io][gltf][join]") {
  Plates plates;
  plates.add(left, R"(,"extensions":{"FB_ngon_encoding":{}})");
  plates.add(right);
  const SceneFile file = plates.scene(R"(,"extensionsUsed":["FB_ngon_encoding"])");
  CHECK(names(file) == Names{"plate.0", "plate.1"});
}

TEST_CASE("one face may run through primitives that share no edge", "[io][gltf][join]") {
  Plates plates;
  plates.add({1, -1, 0, 2, -1, 0, 2, 1, 0, 1, 1, 0});
  plates.add(left);
  plates.add(right);
  CHECK(names(plates.scene()) == Names{"plate"});
  CHECK(faces(plates.scene()) == Faces{0, 0, 0, 0, 0, 0});
}

TEST_CASE("a box of a primitive for each half is closed, with six faces", "[io][gltf][join]") {
  Plates plates;
  for (const float side : {-1.0F, 1.0F}) {  // from x = side to 0
    const float a = side < 0.0F ? -1.0F : 0.0F;
    const float b = a + 1.0F;
    plates.add({a, 0, 0, b, 0, 0, b, 0, 1, a, 0, 1});
    plates.add({b, 1, 0, a, 1, 0, a, 1, 1, b, 1, 1});
    plates.add({a, 1, 0, b, 1, 0, b, 0, 0, a, 0, 0});
    plates.add({a, 0, 1, b, 0, 1, b, 1, 1, a, 1, 1});
  }
  plates.add({-1, 1, 0, -1, 0, 0, -1, 0, 1, -1, 1, 1});
  plates.add({1, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1});
  CHECK(plates.scene().scene.surfaces.faces() == 6);
  const SceneFile file = load_text(
      "scene.gltf", plates.document(R"({"extras":{"csg":"union"},"children":[1]},{"mesh":0})"));
  const auto& leaf = file.scene.solids.at(0).solid.tree().leaves().front();
  CHECK(leaf.shape.face_count() == 6);
}

}  // namespace
}  // namespace raycat
