// The formats that know triangles alone, read back by raycat and by OpenMesh.

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "io/export/obj_file.hpp"
#include "io/export/object_mesh.hpp"
#include "io/export/ply_file.hpp"
#include "io/export/stl_file.hpp"
#include "io/load_scene.hpp"
#include "io/scene/closed_scene.hpp"
#include "tests/io/scene_text.hpp"

namespace raycat {
namespace {

// A plate with a slot, and apart from it two cubes that touch along an edge: 8 x 8 x 2 - 8 x 2 + 2.
constexpr const char* model = R"csg(
difference() {
  cube(size = [8, 8, 2], center = false);
  multmatrix([[1, 0, 0, 0], [0, 1, 0, 3], [0, 0, 1, 1], [0, 0, 0, 1]]) {
    cube(size = [8, 2, 1], center = false);
  }
}
multmatrix([[1, 0, 0, 20.1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {
  union() {
    cube(size = [1, 1, 1], center = false);
    multmatrix([[1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, 0], [0, 0, 0, 1]]) {
      cube(size = [1, 1, 1], center = false);
    }
  }
}
)csg";
constexpr double model_volume = 8 * 8 * 2 - 8 * 2 * 1 + 2;

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    sum += glm::dot(mesh.positions[t.x], glm::cross(mesh.positions[t.y], mesh.positions[t.z]));
  }
  return sum / 6.0;
}

double volume_by_open_mesh(const std::filesystem::path& path) {
  OpenMesh::TriMesh_ArrayKernelT<> mesh;
  REQUIRE(OpenMesh::IO::read_mesh(mesh, path.string()));
  double sum = 0.0;
  for (const auto face : mesh.faces()) {
    std::vector<glm::dvec3> corners;
    for (const auto vertex : mesh.fv_range(face)) {
      const auto& p = mesh.point(vertex);
      corners.emplace_back(p[0], p[1], p[2]);
    }
    sum += glm::dot(corners.at(0), glm::cross(corners.at(1), corners.at(2)));
  }
  return sum / 6.0;
}

void check_reads_back(const std::filesystem::path& path) {
  const SceneFile back = load_scene(path);
  CHECK(is_closed(back.scene));
  CHECK(back.warnings.empty());
  CHECK(volume(back.scene.meshes.at(0).mesh->triangles) == Approx(model_volume).epsilon(1e-6));
  CHECK(volume_by_open_mesh(path) == Approx(model_volume).epsilon(1e-6));
}

TEST_CASE("STL files are read back as the solids that were written", "[io][convert]") {
  const SceneFile scene = load_text("model.csg", model);
  const TemporaryFile place("out.stl", "");
  write_stl(place.path(), object_meshes(scene.scene, 1e-3));
  check_reads_back(place.path());
  const std::string bytes = content(place.path());
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, bytes.data() + 80, 4);
  CHECK(bytes.size() == 84 + std::size_t{50} * triangles);
  CHECK_FALSE(bytes.starts_with("solid"));
}

TEST_CASE("OBJ files have a group for each face", "[io][convert]") {
  const SceneFile scene = load_text("model.csg", model);
  const TemporaryFile place("out.obj", "");
  const std::vector<ObjectMesh> objects = object_meshes(scene.scene, 1e-3);
  write_obj(place.path(), scene.scene.surfaces, objects);
  check_reads_back(place.path());
  std::vector<std::string> groups;
  std::istringstream in(content(place.path()));
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("o ") || line.starts_with("g ")) {
      groups.push_back(line);
    }
  }
  CHECK(groups == std::vector<std::string>{"o difference_line_2",
                                           "g difference_line_2/cube_line_3/0",
                                           "g difference_line_2/cube_line_3/1",
                                           "g difference_line_2/cube_line_3/2",
                                           "g difference_line_2/cube_line_3/3",
                                           "g difference_line_2/cube_line_3/4",
                                           "g difference_line_2/cube_line_3/5",
                                           "g difference_line_2/cube_line_5/2",
                                           "g difference_line_2/cube_line_5/3",
                                           "g difference_line_2/cube_line_5/4",
                                           "o cube_line_10",
                                           "g cube_line_10/cube_line_10/0",
                                           "g cube_line_10/cube_line_10/1",
                                           "g cube_line_10/cube_line_10/2",
                                           "g cube_line_10/cube_line_10/3",
                                           "g cube_line_10/cube_line_10/4",
                                           "g cube_line_10/cube_line_10/5",
                                           "g cube_line_10/cube_line_12/0",
                                           "g cube_line_10/cube_line_12/1",
                                           "g cube_line_10/cube_line_12/2",
                                           "g cube_line_10/cube_line_12/3",
                                           "g cube_line_10/cube_line_12/4",
                                           "g cube_line_10/cube_line_12/5"});
}

TEST_CASE("OBJ coordinates are those of the scene to the last bit", "[io][convert]") {
  const SceneFile scene = load_text("model.csg", model);
  const TemporaryFile place("out.obj", "");
  const std::vector<ObjectMesh> objects = object_meshes(scene.scene, 1e-3);
  write_obj(place.path(), scene.scene.surfaces, objects);
  std::vector<glm::dvec3> expected;
  for (const ObjectMesh& object : objects) {
    const TriangleMesh mesh = welded_mesh(object);
    expected.insert(expected.end(), mesh.positions.begin(), mesh.positions.end());
  }
  std::vector<glm::dvec3> found;
  std::istringstream in(content(place.path()));
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("v ")) {
      std::istringstream numbers(line.substr(2));
      glm::dvec3 p;
      numbers >> p.x >> p.y >> p.z;
      found.push_back(p);
    }
  }
  CHECK((found == expected));
}

TEST_CASE("PLY files tell the object, primitive and face of each triangle", "[io][convert]") {
  const SceneFile scene = load_text("model.csg", model);
  const SurfaceTable& surfaces = scene.scene.surfaces;
  const TemporaryFile place("out.ply", "");
  write_ply(place.path(), surfaces, object_meshes(scene.scene, 1e-3));
  check_reads_back(place.path());
  const std::string bytes = content(place.path());
  const std::size_t body = bytes.find("end_header\n") + 11;
  std::istringstream header(bytes.substr(0, body));
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::map<std::uint32_t, std::string> primitive_names;
  for (std::string line; std::getline(header, line);) {
    std::istringstream words(line);
    std::string first;
    std::string second;
    std::uint32_t number = 0;
    words >> first >> second >> number;
    if (first == "element") {
      (second == "vertex" ? vertices : faces) = number;
    } else if (first == "comment" && second == "primitive") {
      std::getline(words, primitive_names[number]);
    }
  }
  CHECK(primitive_names ==
        std::map<std::uint32_t, std::string>{
            {0, " cube line 3"}, {1, " cube line 5"}, {2, " cube line 10"}, {3, " cube line 12"}});
  constexpr std::size_t record = 1 + 12 + 12;
  REQUIRE(bytes.size() == body + 24 * vertices + record * faces);
  const auto point = [&](std::uint32_t index, std::size_t axis) {
    double value = 0.0;
    std::memcpy(&value, bytes.data() + body + 24 * index + 8 * axis, 8);
    return value;
  };
  // Boxes' faces are -x, +x, -y, +y, -z, +z: the number says across which axis the triangle lies.
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> surfaces_found;
  for (std::size_t i = 0; i < faces; ++i) {
    const char* const at = bytes.data() + body + 24 * vertices + record * i;
    std::array<std::uint32_t, 6> numbers{};
    std::memcpy(numbers.data(), at + 1, 24);
    CHECK(*at == 3);
    const std::size_t axis = numbers[5] / 2;
    CHECK(point(numbers[0], axis) == point(numbers[1], axis));
    CHECK(point(numbers[0], axis) == point(numbers[2], axis));
    surfaces_found.emplace(numbers[3], numbers[4], numbers[5]);
  }
  CHECK(surfaces_found.size() == 6 + 3 + 12);
  CHECK(surfaces_found.contains({0, 1, 4}));
  CHECK_FALSE(surfaces_found.contains({0, 1, 5}));
}

}  // namespace
}  // namespace raycat
