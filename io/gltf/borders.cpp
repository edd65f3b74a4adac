#include "io/gltf/borders.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "io/gltf/accessor.hpp"

namespace raycat {
namespace {

const nlohmann::json* extension_of(const GltfDocument& document, std::size_t mesh,
                                   std::size_t primitive, const char* name) {
  const auto& from = document.json["meshes"][mesh]["primitives"][primitive];
  const auto extensions = from.find("extensions");
  if (extensions == from.end() || !extensions->contains(name)) {
    return nullptr;
  }
  return &extensions->at(name);
}

// The whole numbers of the accessor that a key of an extension names. Of any type, since the
// extension's own sample has them signed.
std::optional<std::vector<std::uint32_t>> numbers(const GltfDocument& document,
                                                  const nlohmann::json& extension,
                                                  const char* key) {
  const auto number = extension.is_object() ? extension.find(key) : extension.end();
  if (!extension.is_object() || number == extension.end() || !is_whole(*number) ||
      number->get<std::uint64_t>() >= document.model.accessors.size()) {
    return std::nullopt;
  }
  const GltfAccessor values(document, number->get<std::size_t>());
  if (values.components() != 1) {
    return std::nullopt;
  }
  std::vector<std::uint32_t> out(values.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double value = values[i].x;
    if (!(value >= 0.0 && value < 0x1p32) || value != std::floor(value)) {
      return std::nullopt;
    }
    out[i] = static_cast<std::uint32_t>(value);
  }
  return out;
}

void warn(GltfDocument& document, std::size_t mesh, std::size_t primitive, const char* extension,
          const char* what) {
  document.warnings.push_back(fmt::format("meshes[{}]: primitives[{}]: {}: {}, and it is ignored",
                                          mesh, primitive, extension, what));
}

std::optional<std::vector<std::uint32_t>> by_offsets(std::span<const std::uint32_t> offsets,
                                                     std::size_t triangles) {
  std::vector<std::uint32_t> polygons(triangles);
  for (std::size_t p = 0; p < offsets.size(); ++p) {
    const std::size_t begin = offsets[p];
    const std::size_t end = p + 1 < offsets.size() ? offsets[p + 1] : 3 * triangles;
    if (begin % 3 != 0 || begin > end || end > 3 * triangles || (p == 0 && begin != 0)) {
      return std::nullopt;
    }
    std::fill(polygons.begin() + static_cast<std::ptrdiff_t>(begin / 3),
              polygons.begin() + static_cast<std::ptrdiff_t>(end / 3),
              static_cast<std::uint32_t>(p));
  }
  return polygons;
}

std::vector<std::uint32_t> by_first_vertex(std::span<const glm::uvec3> triangles) {
  std::vector<std::uint32_t> polygons;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const bool another = i > 0 && triangles[i].x != triangles[i - 1].x;
    polygons.push_back(i == 0 ? 0 : polygons.back() + (another ? 1 : 0));
  }
  return polygons;
}

// Assimp says it of the whole file, and of no primitive.
bool is_ngon_encoded(const GltfDocument& document, std::size_t mesh, std::size_t primitive) {
  const auto used = document.json.value("extensionsUsed", nlohmann::json::array());
  return extension_of(document, mesh, primitive, "FB_ngon_encoding") != nullptr ||
         std::ranges::find(used, "FB_ngon_encoding") != used.end();
}

}  // namespace

std::optional<std::vector<std::uint32_t>> authored_polygons(GltfDocument& document,
                                                            std::size_t mesh, std::size_t primitive,
                                                            std::span<const glm::uvec3> triangles) {
  if (document.model.meshes[mesh].primitives[primitive].mode != TINYGLTF_MODE_TRIANGLES) {
    return std::nullopt;
  }
  if (const auto* extension = extension_of(document, mesh, primitive, "EXT_mesh_polygon")) {
    const auto offsets = numbers(document, *extension, "indicesOffsets");
    if (auto polygons = offsets && offsets->size() > 0 ? by_offsets(*offsets, triangles.size())
                                                       : std::nullopt) {
      return polygons;
    }
    warn(document, mesh, primitive, "EXT_mesh_polygon",
         "indicesOffsets do not cut the indices into polygons");
  }
  if (is_ngon_encoded(document, mesh, primitive)) {
    return by_first_vertex(triangles);
  }
  return std::nullopt;
}

std::optional<std::vector<glm::uvec2>> authored_outline(GltfDocument& document, std::size_t mesh,
                                                        std::size_t primitive, std::size_t count) {
  const char* const name = "CESIUM_primitive_outline";
  const auto* extension = extension_of(document, mesh, primitive, name);
  if (extension == nullptr) {
    return std::nullopt;
  }
  const auto ends = numbers(document, *extension, "indices");
  if (!ends || ends->size() % 2 != 0) {
    warn(document, mesh, primitive, name, "indices are no pairs of vertices");
    return std::nullopt;
  }
  std::vector<glm::uvec2> edges;
  for (std::size_t i = 0; i < ends->size(); i += 2) {
    edges.emplace_back((*ends)[i], (*ends)[i + 1]);
    if (edges.back().x >= count || edges.back().y >= count) {
      warn(document, mesh, primitive, name, "indices are past the vertices");
      return std::nullopt;
    }
  }
  return edges;
}

}  // namespace raycat
