#include "io/meshes/mesh_file.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "io/scene/closed_scene.hpp"
#include "tests/io/scene_text.hpp"

namespace raycat {
namespace {

const std::string obj =
    "mtllib /dev/zero\nv 0 0 0\nv 1 0 0 # along x\nv 0 1 0\nv 0 0 1\nvt 0 0\nvn 0 0 1\nusemtl a\n"
    "f 3/1/1 2//1 1\nf 1 2 -1\nf 2 3 4\nf 3 1 \\\n 4\n";
const std::string off =
    "OFF 4 4 6\n# points\n0 0 0\n1 0 0\n0 1 0\n\n0 0 1\n3 2 1 0\n3  0 1 3\n3 1 2 3\n3 2 0 3";
const std::string ply =
    "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nproperty uchar foo\nelement face 4\nproperty list uchar int vertex_index\n"
    "end_header\n0 0 0 7\n1 0 0 7\n0 1 0 7\n0 0 1 7\n3 2 1 0\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

std::string text_stl() {
  const std::vector<const char*> points = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
  std::string text = "solid a\n";
  for (const auto& [a, b, c] : {std::array{2, 1, 0}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    text += "  facet normal 0 0 1\n    outer loop\n";
    for (const int corner : {a, b, c}) {
      text += std::string("      vertex ") + points[static_cast<std::size_t>(corner)] + "\n";
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid a\n";
}

template <typename Number>
void put(std::string& bytes, Number number) {
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  bytes.append(raw, sizeof number);
}

std::string binary_stl(std::uint32_t promised) {
  std::string bytes(80, ' ');
  put(bytes, promised);
  const float points[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const auto& triangle : {std::array{2, 1, 0}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    bytes.append(12, '\0');
    for (const int corner : triangle) {
      for (const float coordinate : points[corner]) {
        put(bytes, coordinate);
      }
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string binary_ply(std::uint32_t vertices) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(vertices) +
                      "\nproperty float x\nproperty float y\nproperty float z\n"
                      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (const float coordinate : {0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f}) {
    put(bytes, coordinate);
  }
  put(bytes, std::uint8_t{3});
  for (const std::int32_t corner : {0, 1, 2}) {
    put(bytes, corner);
  }
  return bytes;
}

TEST_CASE("a tetrahedron is the same from every kind of mesh file", "[io][mesh]") {
  const auto [name, content] = GENERATE(table<std::string, std::string>({
      {"a.obj", obj},
      {"a.off", off},
      {"a.ply", ply},
      {"a.stl", text_stl()},
      {"b.stl", binary_stl(4)},
  }));
  INFO(name);
  const SceneFile file = load_text(name, content);
  CHECK(file.triangles == 4);
  CHECK(is_closed(file.scene));
  CHECK(file.scene.surfaces.objects() == 1);
  CHECK(file.scene.surfaces.primitives() == 1);
  CHECK(file.scene.surfaces.faces() == 4);
  CHECK(file.scene.surfaces.name(ObjectId{0}) == name.substr(0, 1));
  CHECK(bounds(file.scene.meshes.at(0).mesh->triangles).max == glm::dvec3(1.0));
  const bool z_up = name.ends_with("stl") || name.ends_with("off");
  CHECK(file.up == (z_up ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0)));
}

TEST_CASE("binary PLY is read after text PLY and the other way round", "[io][mesh]") {
  for (int i = 0; i < 2; ++i) {
    CHECK(load_text("a.ply", ply).triangles == 4);
    const SceneFile open = load_text("b.ply", binary_ply(3));
    CHECK(open.triangles == 1);
    CHECK_FALSE(is_closed(open.scene));
  }
}

TEST_CASE("triangles that are not manifold are kept", "[io][mesh]") {
  CHECK(load_text("a.obj",
                  "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\n"
                  "f 1 2 3\nf 1 2 4\nf 1 2 5\nf 2 1 3\nf 1 2 3\n")
            .triangles == 5);
}

TEST_CASE("colours, normals and texture coordinates of OFF files are passed over", "[io][mesh]") {
  CHECK(load_text("a.off", "OFF 3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n").triangles == 1);
  CHECK(load_text("a.off", "COFF\n3 1 0\n0 0 0 1 2 3 4\n1 0 0 1\n0 1 0\n3 0 1 2\n").triangles == 1);
  CHECK(load_text("a.off",
                  "STCNOFF\n3 1\n0 0 0 0 0 1 9 9 9 .5 .5\n1 0 0 0 0 1\n"
                  "0 1 0 0 0 1\n3 0 1 2 7\n")
            .triangles == 1);
}

TEST_CASE("polygons are triangulated", "[io][mesh]") {
  CHECK(load_text("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n").triangles == 2);
}

TEST_CASE("a coordinate too small for a double is 0, however it is written", "[io][mesh]") {
  const std::string small =
      GENERATE(as<std::string>(), "1e-400", "1E-400", "-1E-400", "+1.5E-99999999999",
               "0." + std::string(400, '0') + "1", "1" + std::string(99, '0') + "E-500");
  const std::string rest = "v 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const SceneFile file = load_text("a.obj", "v " + small + " 0 0\n" + rest);
  CHECK(bounds(file.scene.meshes.at(0).mesh->triangles).min == glm::dvec3(0.0));
}

TEST_CASE("a coordinate too large for a double is refused, however it is written", "[io][mesh]") {
  const std::string large =
      GENERATE(as<std::string>(), "1e400", "1E+400", "1" + std::string(400, '0'),
               "1" + std::string(400, '0') + "e-5", "0.01E99999999999");
  CHECK(load_error("a.obj", "v " + large + " 0 0\n") ==
        "a.obj: line 1: a vertex needs three finite numbers");
}

TEST_CASE("malformed mesh files are refused with one line", "[io][mesh]") {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  CHECK(load_error("a.obj", three) == "a.obj: holds no triangle");
  CHECK(load_error("a.obj", three + "f 1 2\n") == "a.obj: line 4: a face needs three corners");
  CHECK(load_error("a.obj", three + "f 1 2 x\n") == "a.obj: line 4: 'x' is no corner of a face");
  CHECK(load_error("a.obj", "v 0 0 nan\n") == "a.obj: line 1: a vertex needs three finite numbers");
  CHECK(load_error("a.obj", "v 0 0 1e99\n") ==
        "a.obj: line 1: a vertex needs three finite numbers");
  CHECK_FALSE(load_error("a.obj", three + "f 1 2 4\n").empty());
  CHECK_FALSE(load_error("a.obj", three + "f 1 2 -9\n").empty());
  CHECK(load_error("a.stl", binary_stl(5)) ==
        "a.stl: the header promises 5 triangles, but the file holds 4");
  CHECK(load_error("a.stl", binary_stl(4'000'000'000)) ==
        "a.stl: the header promises 4000000000 triangles, but the file holds 4");
  CHECK(load_error("a.stl", "rubbish") ==
        "a.stl: is neither a text STL file nor long enough for a binary one");
  CHECK(load_error("a.stl", text_stl().substr(0, 100)) == "a.stl: ends before endsolid");
  CHECK(load_error("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 inf\n") ==
        "a.stl: line 4: a vertex needs three finite numbers");
  CHECK(load_error("a.stl", "solid a\nfacet normal 0 0 1\n") == "a.stl: ends before endsolid");
  CHECK(load_error("a.ply", binary_ply(4'000'000'000)) ==
        "a.ply: the header promises 4000000000 of 'vertex', more than the file holds");
  CHECK(load_error("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n") ==
        "a.ply: line 4: expected end_header");
  CHECK(load_error("a.ply", ply.substr(0, ply.size() - 8)) == "a.ply: is truncated or malformed");
  CHECK(load_error("a.off", off.substr(0, off.size() - 8)) ==
        "a.off: ends before its last vertex or face");
  CHECK(load_error("a.off", "OFF\n4000000000 1 0\n0 0 0\n") ==
        "a.off: ends before its last vertex or face");
  CHECK(load_error("a.off", "FFO\n") == "a.off: line 1: expected OFF");
}

TEST_CASE("damaged mesh files load or are refused with one line", "[io][mesh]") {
  const auto [name, content] = GENERATE(table<std::string, std::string>({
      {"a.obj", obj},
      {"a.off", off},
      {"b.off", "COFF\n3 1 0\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n3 0 1 2 9 9 9\n"},
      {"a.ply", ply},
      {"b.ply", binary_ply(3)},
      {"a.stl", text_stl()},
      {"b.stl", binary_stl(4)},
  }));
  CHECK(rc::check("damage", [&name = name, &content = content] {
    std::string damaged = content;
    const int bytes = *rc::gen::inRange(0, 4);
    for (int i = 0; i < bytes; ++i) {
      damaged[*rc::gen::inRange<std::size_t>(0, damaged.size())] = *rc::gen::arbitrary<char>();
    }
    damaged.resize(*rc::gen::inRange<std::size_t>(1, damaged.size() + 1));
    RC_ASSERT(load_error("damaged-" + name, damaged).find('\n') == std::string::npos);
  }));
}

}  // namespace
}  // namespace raycat
