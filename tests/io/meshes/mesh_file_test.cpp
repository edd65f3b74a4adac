#include "io/meshes/mesh_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
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

void put_big(std::string& bytes, std::int32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes.push_back(static_cast<char>(number >> shift));
  }
}

// A number of a PLY type.
void put_as(std::string& bytes, const std::string& type, double number, bool big) {
  std::string little;
  if (type == "char" || type == "uint8") {
    put(little, static_cast<std::uint8_t>(number));
  } else if (type == "short" || type == "ushort") {
    put(little, static_cast<std::uint16_t>(number));
  } else if (type == "int" || type == "uint") {
    put(little, static_cast<std::uint32_t>(number));
  } else if (type == "float") {
    put(little, static_cast<float>(number));
  } else {
    put(little, number);
  }
  if (big) {
    std::ranges::reverse(little);
  }
  bytes += little;
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

const std::string box_points = "0 0 0\n4 0 0\n0 3 0\n4 3 0\n0 0 2\n4 0 2\n0 3 2\n4 3 2\n";
const std::string box_faces = "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";

// Is it the box above, closed and right side out?
void check_box(const std::string& name, const std::string& content) {
  CAPTURE(name);
  CAPTURE(content.substr(0, content.find("end_header")));
  const SceneFile file = load_text(name, content);
  CHECK(file.triangles == 12);
  CHECK(file.warnings.empty());
  CHECK(is_closed(file.scene));
  const TriangleMesh& mesh = file.scene.meshes.at(0).mesh->triangles;
  CHECK(mesh.positions.size() == 8);
  CHECK(mesh.face_count == 6);
  double volume = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    volume +=
        glm::dot(mesh.positions[t.x], glm::cross(mesh.positions[t.y], mesh.positions[t.z])) / 6.0;
  }
  CHECK(volume == Approx(24.0));
}

TEST_CASE("OFF files are laid out as people lay them out", "[io][mesh]") {
  std::string wrapped = box_points + box_faces;
  std::ranges::replace(wrapped, '\n', ' ');
  check_box("a.off", "# by hand\nOFF\n# counts\n8 6 12\n\n" + box_points + box_faces);
  check_box("a.off", "OFF8 6 0\n" + box_points + box_faces);
  check_box("a.off", "OFF # counts\n8 6\n" + box_points + box_faces);
  check_box("a.off", "OFF 8 6 12\n" + wrapped);
  std::ranges::replace(wrapped, ' ', '\n');
  check_box("a.off", "OFF\n8\n6\n12\n" + wrapped);
  std::string numbers = "COFF 8 6 0";
  std::istringstream points(box_points);
  for (std::string line; std::getline(points, line);) {
    numbers += " " + line + " 1 .5 0 1";
  }
  check_box("a.off", numbers + "\n" + box_faces);
  std::string binary = "OFF BINARY\n";
  put_big(binary, 8);
  put_big(binary, 6);
  put_big(binary, 12);
  std::istringstream floats(box_points);
  for (float number = 0; floats >> number;) {
    put_big(binary, std::bit_cast<std::int32_t>(number));
  }
  std::istringstream ints(box_faces);
  for (std::int32_t number = 0, i = 0; ints >> number; ++i) {
    put_big(binary, number);
    if (i % 5 == 4) {
      put_big(binary, 0);  // of colour
    }
  }
  check_box("a.off", binary);
}

// Every scalar type in every place of a PLY file in each format.
TEST_CASE("PLY files hold numbers and lists of any type, before, after and beside the rest",
          "[io][mesh]") {
  const std::vector<std::string> types = {"char", "uint8", "short", "ushort",
                                          "int",  "uint",  "float", "float64"};
  const auto format =
      GENERATE(as<std::string>(), "ascii", "binary_little_endian", "binary_big_endian");
  for (std::size_t i = 0; i < types.size(); ++i) {
    const std::string& type = types[i];
    const std::string& count = types[(i + 3) % types.size()];
    std::string header = "ply\nformat " + format + " 1.0\ncomment by hand\n";
    std::string bytes;
    const auto write = [&](const std::string& of, double number) {
      if (format == "ascii") {
        bytes += std::to_string(static_cast<int>(number)) + (bytes.size() % 7 == 0 ? "\n" : " ");
      } else {
        put_as(bytes, of, number, format == "binary_big_endian");
      }
    };
    header += "element camera 1\nproperty list " + type + " " + count + " lens\n";
    write(type, 2);
    write(count, 9);
    write(count, 8);
    header += "element vertex 8\nproperty " + count + " w\nproperty " + type + " x\nproperty " +
              type + " y\nproperty list " + count + " " + type + " texcoord\nproperty " + type +
              " z\n";
    std::istringstream points(box_points);
    for (double x = 0, y = 0, z = 0; points >> x >> y >> z;) {
      write(count, 5);
      write(type, x);
      write(type, y);
      write(count, 1);
      write(type, 7);
      write(type, z);
    }
    header += "element face 6\nproperty list " + count + " " + type + " texcoord\nproperty list " +
              count + " " + type + " vertex_index\nproperty " + type + " flags\n";
    std::istringstream faces(box_faces);
    for (double n = 0, a = 0, b = 0, c = 0, d = 0; faces >> n >> a >> b >> c >> d;) {
      write(count, 2);
      write(type, 1);
      write(type, 1);
      write(count, n);
      for (const double corner : {a, b, c, d}) {
        write(type, corner);
      }
      write(type, 3);
    }
    header += "element edge 1\nproperty int vertex1\nend_header\n";
    write("int", 0);
    check_box("a.ply", header + bytes);
  }
}

TEST_CASE("triangle strips of PLY files turn and end", "[io][mesh]") {
  // Around the sides of the box, then the bottom and the top.
  check_box("a.ply",
            "ply\nformat ascii 1.0\nelement vertex 8\nproperty short x\nproperty short y\n"
            "property short z\nelement tristrips 1\nproperty list int int vertex_indices\n"
            "end_header\n" +
                box_points + "20 4 0 5 1 7 3 6 2 4 0 -1 1 0 3 2 -1 4 5 6 7\n");
}

TEST_CASE("text STL is read in capitals, with ends in two words and without", "[io][mesh]") {
  const std::string text = text_stl();
  const auto with = [&](const std::string& what, const std::string& instead) {
    std::string out = text;
    for (std::size_t at = out.find(what); at != std::string::npos;
         at = out.find(what, at + instead.size())) {
      out.replace(at, what.size(), instead);
    }
    return out;
  };
  std::string capitals = text;
  std::ranges::transform(capitals, capitals.begin(),
                         [](unsigned char c) { return std::toupper(c); });
  for (const std::string& content :
       {capitals, with("endsolid", "end solid"), with("endloop", "end loop"),
        with("endfacet", "End Facet"), with("\n", "\r\n"), text + text_stl()}) {
    const SceneFile file = load_text("a.stl", content);
    CHECK(is_closed(file.scene));
    CHECK(file.warnings.empty());
  }
  const SceneFile cut = load_text("a.stl", with("endsolid a\n", ""));
  CHECK(is_closed(cut.scene));
  CHECK(cut.warnings ==
        std::vector<std::string>{"ends without endsolid, and may have been longer"});
}

TEST_CASE("binary STL may begin with solid and end with more", "[io][mesh]") {
  for (const std::string& rest : {std::string(), std::string(7, '\0')}) {
    std::string bytes = binary_stl(4) + rest;
    bytes.replace(0, 5, "solid");
    CHECK(load_text("a.stl", bytes).triangles == 4);
  }
}

TEST_CASE("coordinates of mesh files are read as doubles", "[io][mesh]") {
  const std::string point = "5412350.0293417";
  const std::string other = " 1 0\n";
  const auto [name, content] = GENERATE_COPY(table<std::string, std::string>({
      {"a.obj", "v " + point + other + "v 0 1 1\nv 0 0 0\nf 1 2 3\n"},
      {"a.off", "OFF 3 1 0\n" + point + other + "0 1 1\n0 0 0\n3 0 1 2\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double "
       "y\nproperty double z\nelement face 1\nproperty list uchar int "
       "vertex_indices\nend_header\n" +
           point + other + "0 1 1\n0 0 0\n3 0 1 2\n"},
      {"a.stl", "solid\nfacet normal 0 0 0\nouter loop\nvertex " + point + other +
                    "vertex 0 1 1\nvertex 0 0 0\nendloop\nendfacet\nendsolid\n"},
  }));
  CAPTURE(name);
  CHECK(bounds(load_text(name, content).scene.meshes.at(0).mesh->triangles).max.x ==
        5412350.0293417);
}

// A square with a square hole, which a bridge joins to the outside: two corners are named twice.
TEST_CASE("a hole on a bridge is a hole", "[io][mesh]") {
  const SceneFile file =
      load_text("a.obj",
                "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\n"
                "f 1 2 3 4 1 5 6 7 8 5\n");
  const TriangleMesh& mesh = file.scene.meshes.at(0).mesh->triangles;
  double area = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    area += 0.5 * glm::length(glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                         mesh.positions[t.z] - mesh.positions[t.x]));
  }
  CHECK(area == Approx(12.0));
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
  CHECK(load_error("a.obj", three + "f 1 2 4\n") ==
        "a.obj: face 0 has corner 3, but there are 3 points");
  CHECK(load_error("a.obj", three + "f 1 2 -9\n") == "a.obj: line 4: there is no vertex -9");
  CHECK(load_error("a.stl", binary_stl(5)) ==
        "a.stl: the header promises 5 triangles, but the file holds 4");
  CHECK(load_error("a.stl", binary_stl(4'000'000'000)) ==
        "a.stl: the header promises 4000000000 triangles, but the file holds 4");
  CHECK(load_error("a.stl", "rubbish") ==
        "a.stl: is neither a text STL file nor long enough for a binary one");
  CHECK(load_error("a.stl", text_stl().substr(0, 100)) == "a.stl: ends within a facet");
  CHECK(load_error("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 inf\n") ==
        "a.stl: line 4: a vertex needs three finite numbers");
  CHECK(load_error("a.stl", "solid a\nfacet normal 0 0 1\n") == "a.stl: ends within a facet");
  CHECK(load_error("a.ply", binary_ply(4'000'000'000)) ==
        "a.ply: the header promises 4000000000 of 'vertex', more than the file holds");
  CHECK(load_error("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n") ==
        "a.ply: line 4: expected end_header");
  CHECK(load_error("a.ply", ply.substr(0, ply.size() - 8)) == "a.ply: is truncated");
  std::string with_zero = ply;
  with_zero.replace(with_zero.find("0 0 0 7"), 2, std::string("0\0", 2));
  CHECK(load_error("a.ply", with_zero) == "a.ply: line 12: '0 0' is not a number");
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
