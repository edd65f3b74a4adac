#include "io/export/glb_file.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include "io/export/material_json.hpp"
#include "io/export/view_json.hpp"
#include "io/files/byte_buffer.hpp"
#include "io/files/output_file.hpp"

namespace raycat {
namespace {

using Json = nlohmann::ordered_json;

constexpr int vertices_target = 34962;
constexpr int indices_target = 34963;
constexpr int unsigned_int = 5125;
constexpr int single_float = 5126;
constexpr std::size_t most_features = std::size_t{1} << 24;  // whole numbers that a float holds
constexpr std::size_t most_bytes = std::numeric_limits<std::uint32_t>::max() - 1024U;

// Vertices of one primitive, each of one face.
struct Vertices {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec4> colours;
  std::vector<float> features;
  std::vector<std::uint32_t> indices;
};

Vertices split_at_faces(const SurfaceMesh& mesh,
                        const std::unordered_map<std::uint32_t, std::uint32_t>& feature_of) {
  Vertices out;
  std::unordered_map<std::uint64_t, std::uint32_t> known;
  const TriangleMesh& triangles = mesh.triangles;
  for (std::size_t i = 0; i < triangles.triangles.size(); ++i) {
    const glm::uvec3& t = triangles.triangles[i];
    const glm::vec3 a(triangles.positions[t.x]);
    const glm::vec3 b(triangles.positions[t.y]);
    const glm::vec3 c(triangles.positions[t.z]);
    if (a == b || b == c || c == a) {
      continue;  // rounding has made nothing of it
    }
    const std::uint32_t feature = feature_of.at(triangles.faces[i]);
    for (int k = 0; k < 3; ++k) {
      const auto [found, is_new] = known.try_emplace(
          std::uint64_t{feature} << 32U | t[k], static_cast<std::uint32_t>(out.positions.size()));
      if (is_new) {
        out.positions.emplace_back(triangles.positions[t[k]]);
        out.features.push_back(static_cast<float>(feature));
        if (!mesh.normals.empty()) {
          out.normals.push_back(mesh.normals[t[k]]);
        }
        if (!mesh.colours.empty()) {
          out.colours.push_back(mesh.colours[t[k]]);
        }
      }
      out.indices.push_back(found->second);
    }
  }
  return out;
}

class GlbWriter {
 public:
  GlbWriter(const Scene& scene, std::vector<std::string>& warnings)
      : scene_(scene), warnings_(warnings) {
    document_["asset"] = {{"version", "2.0"}, {"generator", "raycat"}};
    document_["scene"] = 0;
    document_["scenes"] = Json::array({{{"nodes", Json::array()}}});
    document_["nodes"] = Json::array();
    for (const Material& material : scene.materials) {
      document_["materials"].push_back(material_json(material, extensions_, warnings_));
    }
  }

  void add(const ObjectMesh& object) {
    const std::string& name = scene_.surfaces.name(object.object);
    if (object.endless != nullptr && add_half_space(name, *object.endless)) {
      return;
    }
    const std::vector<std::uint32_t> faces = faces_of(object);
    if (faces.size() > most_features) {
      throw std::length_error(
          fmt::format("{}: a glTF mesh has at most {} faces", name, most_features));
    }
    std::unordered_map<std::uint32_t, std::uint32_t> feature_of;
    for (std::uint32_t feature = 0; feature < faces.size(); ++feature) {
      feature_of[faces[feature]] = feature;
    }
    Json primitives = Json::array();
    for (const ObjectMesh::Part& part : object.parts) {
      const Vertices vertices = split_at_faces(part.mesh, feature_of);
      if (!vertices.indices.empty()) {
        primitives.push_back(primitive(vertices, part.material, faces.size()));
      }
    }
    if (primitives.empty()) {
      const auto lines = without_parts(scene_.surfaces, {&object, 1});
      warnings_.insert(warnings_.end(), lines.begin(), lines.end());
      return;
    }
    add_node({{"name", name}, {"mesh", document_["meshes"].size()}});
    document_["meshes"].push_back({{"name", name},
                                   {"primitives", std::move(primitives)},
                                   {"extras", {{"raycat", names(object, faces)}}}});
  }

  void write(const std::filesystem::path& path) {
    add_view_json(scene_, document_);
    if (document_.contains("meshes")) {
      extensions_.emplace_back("EXT_mesh_features");
    }
    if (document_.contains("extensions")) {
      extensions_.emplace_back("KHR_lights_punctual");
    }
    if (!extensions_.empty()) {
      document_["extensionsUsed"] = extensions_;
    }
    if (binary_.size() > 0) {
      document_["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
    }
    const std::string json = document_.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (json.size() + binary_.size() > most_bytes) {
      throw std::length_error("a .glb file has at most 4 GiB");
    }
    ByteBuffer out;
    out.put(std::string_view("glTF"));
    out.put(std::uint32_t{2});
    const auto padded = static_cast<std::uint32_t>((json.size() + 3) / 4 * 4);
    const auto bytes = static_cast<std::uint32_t>(binary_.size());
    out.put(12 + 8 + padded + (bytes > 0 ? 8 + bytes : 0));
    out.put(padded);
    out.put(std::string_view("JSON"));
    out.put(std::string_view(json));
    out.align(4, ' ');
    if (bytes > 0) {
      out.put(bytes);
      out.put(std::string_view("BIN\0", 4));
      out.put(std::string_view(reinterpret_cast<const char*>(binary_.bytes().data()), bytes));
    }
    write_file(path, out.bytes());
  }

 private:
  void add_node(Json node) {
    document_["scenes"][0]["nodes"].push_back(document_["nodes"].size());
    document_["nodes"].push_back(std::move(node));
  }

  // A half-space alone is a shape that our extras can say.
  bool add_half_space(const std::string& name, const SolidObject& object) {
    const auto leaves = object.solid.tree().leaves();
    if (leaves.size() != 1 || !std::holds_alternative<HalfSpace>(leaves.front().shape.shape())) {
      return false;
    }
    const glm::dmat4 world = leaves.front().shape.transform().matrix();
    Json matrix = Json::array();
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) {
        matrix.push_back(world[column][row]);
      }
    }
    add_node({{"name", name},
              {"matrix", std::move(matrix)},
              {"extras",
               {{"shape", {{"type", "plane"}}},
                {"material", static_cast<std::uint32_t>(object.materials.front())}}}});
    return true;
  }

  static std::vector<std::uint32_t> faces_of(const ObjectMesh& object) {
    std::vector<std::uint32_t> faces;
    for (const ObjectMesh::Part& part : object.parts) {
      faces.insert(faces.end(), part.mesh.triangles.faces.begin(), part.mesh.triangles.faces.end());
    }
    std::ranges::sort(faces);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
  }

  // Primitives without any feature are listed too, so that all faces are numbered as before.
  Json names(const ObjectMesh& object, const std::vector<std::uint32_t>& faces) const {
    const SurfaceTable& surfaces = scene_.surfaces;
    const auto first = static_cast<std::uint32_t>(object.first_face);
    Json primitives = Json::array();
    std::vector<std::uint32_t> starts;
    for (std::uint32_t face = first;
         face < surfaces.faces() && surfaces.object(SurfaceId{face}) == object.object;) {
      const PrimitiveId primitive = surfaces.primitive(SurfaceId{face});
      const std::uint32_t begin = face;
      while (face < surfaces.faces() && surfaces.primitive(SurfaceId{face}) == primitive) {
        ++face;
      }
      starts.push_back(begin - first);
      primitives.push_back({{"name", surfaces.name(primitive)}, {"faces", face - begin}});
    }
    Json features = Json::array();
    std::size_t primitive = 0;
    for (const std::uint32_t face : faces) {
      while (primitive + 1 < starts.size() && starts[primitive + 1] <= face) {
        ++primitive;
      }
      features.push_back({primitive, face - starts[primitive]});
    }
    return {{"object", surfaces.name(object.object)},
            {"primitives", std::move(primitives)},
            {"features", std::move(features)}};
  }

  Json primitive(const Vertices& vertices, MaterialId material, std::size_t features) {
    Json attributes{{"POSITION", positions(vertices.positions)}};
    if (!vertices.normals.empty()) {
      attributes["NORMAL"] = floats(&vertices.normals.front().x, 3, vertices.normals.size());
    }
    if (!vertices.colours.empty()) {
      attributes["COLOR_0"] = floats(&vertices.colours.front().x, 4, vertices.colours.size());
    }
    attributes["_FEATURE_ID_0"] = floats(vertices.features.data(), 1, vertices.features.size());
    const std::size_t begin = binary_.size();
    for (const std::uint32_t index : vertices.indices) {
      binary_.put(index);
    }
    const std::size_t indices =
        accessor(begin, indices_target, unsigned_int, "SCALAR", vertices.indices.size());
    const auto ids = Json::array({{{"featureCount", features}, {"attribute", 0}}});
    return {{"attributes", std::move(attributes)},
            {"indices", indices},
            {"material", static_cast<std::uint32_t>(material)},
            {"extensions", {{"EXT_mesh_features", {{"featureIds", ids}}}}}};
  }

  std::size_t positions(const std::vector<glm::vec3>& points) {
    glm::vec3 least = points.front();
    glm::vec3 most = points.front();
    for (const glm::vec3& point : points) {
      least = glm::min(least, point);
      most = glm::max(most, point);
    }
    const std::size_t number = floats(&points.front().x, 3, points.size());
    Json& accessor = document_["accessors"][number];
    accessor["min"] = {least.x, least.y, least.z};
    accessor["max"] = {most.x, most.y, most.z};
    return number;
  }

  std::size_t floats(const float* data, int components, std::size_t count) {
    const std::size_t begin = binary_.size();
    for (std::size_t i = 0; i < count * static_cast<std::size_t>(components); ++i) {
      binary_.put(data[i]);
    }
    const char* const type = components == 1 ? "SCALAR" : components == 3 ? "VEC3" : "VEC4";
    return accessor(begin, vertices_target, single_float, type, count);
  }

  // Everything has components of four bytes, so that all is aligned.
  std::size_t accessor(std::size_t begin, int target, int component, const char* type,
                       std::size_t count) {
    document_["bufferViews"].push_back({{"buffer", 0},
                                        {"byteOffset", begin},
                                        {"byteLength", binary_.size() - begin},
                                        {"target", target}});
    document_["accessors"].push_back({{"bufferView", document_["bufferViews"].size() - 1},
                                      {"componentType", component},
                                      {"count", count},
                                      {"type", type}});
    return document_["accessors"].size() - 1;
  }

  const Scene& scene_;
  std::vector<std::string>& warnings_;
  Json document_;
  ByteBuffer binary_;
  std::vector<std::string> extensions_;
};

}  // namespace

void write_glb(const std::filesystem::path& path, const Scene& scene,
               std::span<const ObjectMesh> objects, std::vector<std::string>& warnings) {
  GlbWriter writer(scene, warnings);
  for (const ObjectMesh& object : objects) {
    writer.add(object);
  }
  writer.write(path);
}

}  // namespace raycat
