#include "io/gltf/draco.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <draco/compression/decode.h>
#include <fmt/format.h>

#include "io/files/excerpt.hpp"
#include "io/files/load_error.hpp"
#include "io/gltf/draco_header.hpp"

namespace raycat {
namespace {

using nlohmann::json;

constexpr int unsigned_int = 5125;
constexpr int float_type = 5126;

std::unique_ptr<draco::Mesh> decoded(std::span<const std::uint8_t> bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
  if (!mesh.ok()) {
    throw std::runtime_error(excerpt(mesh.status().error_msg_string()));
  }
  return std::move(mesh).value();
}

Bytes indices_of(const draco::Mesh& mesh) {
  Bytes bytes(std::size_t{mesh.num_faces()} * 3 * sizeof(std::uint32_t));
  for (std::uint32_t i = 0; i < mesh.num_faces(); ++i) {
    const draco::Mesh::Face& face = mesh.face(draco::FaceIndex(i));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t corner = face[k].value();
      std::memcpy(bytes.data() + (3 * std::size_t{i} + k) * sizeof corner, &corner, sizeof corner);
    }
  }
  return bytes;
}

// Numbers as they are: what is normalized is so by the accessor.
template <typename T>
Bytes values_of(const draco::Mesh& mesh, const draco::PointAttribute& attribute, int components) {
  const std::size_t size = sizeof(T) * static_cast<std::size_t>(components);
  Bytes bytes(mesh.num_points() * size);
  std::vector<T> element(static_cast<std::size_t>(components));
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i) {
    if (!attribute.ConvertValue<T>(attribute.mapped_index(draco::PointIndex(i)),
                                   static_cast<std::int8_t>(components), element.data())) {
      throw std::runtime_error("an attribute's values do not fit its accessor");
    }
    std::memcpy(bytes.data() + i * size, element.data(), size);
  }
  return bytes;
}

Bytes values_of(const draco::Mesh& mesh, const draco::PointAttribute& attribute, int components,
                int component_type) {
  switch (component_type) {
    case 5120:
      return values_of<std::int8_t>(mesh, attribute, components);
    case 5121:
      return values_of<std::uint8_t>(mesh, attribute, components);
    case 5122:
      return values_of<std::int16_t>(mesh, attribute, components);
    case 5123:
      return values_of<std::uint16_t>(mesh, attribute, components);
    case unsigned_int:
      return values_of<std::uint32_t>(mesh, attribute, components);
    case float_type:
      return values_of<float>(mesh, attribute, components);
    default:
      throw std::runtime_error(
          fmt::format("component type {} is not one of glTF 2.0", component_type));
  }
}

int components_of(const std::string& type) {
  if (type == "SCALAR") {
    return 1;
  }
  if (type == "VEC2" || type == "VEC3" || type == "VEC4") {
    return type.back() - '0';
  }
  throw std::runtime_error(fmt::format("attributes of type {} are not in Draco", excerpt(type)));
}

/// Decodes one primitive. Nothing in the document changes before all of it is decoded.
class PrimitiveDecoder {
 public:
  PrimitiveDecoder(GltfDocument& document, LoadBudget& budget, std::string place)
      : document_(document), budget_(budget), place_(std::move(place)) {}

  void decode(json& primitive, JsonFields& extension) {
    const json& accessors = document_.json["accessors"];
    const auto view = extension.index("bufferView", "bufferViews",
                                      document_.json.value("bufferViews", json::array()).size());
    if (!view) {
      extension.fail("bufferView: is missing");
    }
    const auto bytes = document_.json_view_bytes(*view);
    reserve(bytes);
    const std::unique_ptr<draco::Mesh> mesh = decoded(bytes);
    if (primitive.contains("indices")) {
      json accessor = accessors.at(primitive["indices"].get<std::size_t>());
      accessor["componentType"] = unsigned_int;
      accessor["type"] = "SCALAR";
      add(std::move(accessor), indices_of(*mesh), std::size_t{mesh->num_faces()} * 3);
    } else {
      add({{"componentType", unsigned_int}, {"type", "SCALAR"}}, indices_of(*mesh),
          std::size_t{mesh->num_faces()} * 3);
    }
    std::vector<std::string> names;
    const json& attributes = primitive.at("attributes");
    for (const auto& [name, id] : extension.whole_numbers("attributes")) {
      const auto number = attributes.find(name);
      if (number == attributes.end()) {
        continue;  // what the primitive itself does not have is not asked for
      }
      const draco::PointAttribute* attribute =
          id <= std::numeric_limits<std::uint32_t>::max()
              ? mesh->GetAttributeByUniqueId(static_cast<std::uint32_t>(id))
              : nullptr;
      if (attribute == nullptr) {
        throw std::runtime_error(fmt::format("there is no attribute {} for {}", id, excerpt(name)));
      }
      json accessor = accessors.at(number->get<std::size_t>());
      Bytes values = values_of(*mesh, *attribute, components_of(accessor.at("type")),
                               accessor.at("componentType"));
      add(std::move(accessor), std::move(values), mesh->num_points());
      names.push_back(name);
    }
    store(primitive, names);
  }

 private:
  struct Decoded {
    json accessor;
    Bytes bytes;
  };

  void reserve(std::span<const std::uint8_t> bytes) {
    const DracoHeader header = draco_header(bytes);
    constexpr std::uint64_t bytes_each = 64;  // what the decoder holds while it works
    budget_.take_memory(document_.file, place_, header.faces, bytes_each);
    budget_.take_memory(document_.file, place_, header.points, bytes_each);
  }

  void add(json accessor, Bytes bytes, std::size_t count) {
    for (const char* key : {"bufferView", "byteOffset", "sparse", "min", "max"}) {
      accessor.erase(key);
    }
    accessor["count"] = count;
    decoded_.push_back({.accessor = std::move(accessor), .bytes = std::move(bytes)});
  }

  // The first that was added are the indices.
  void store(json& primitive, const std::vector<std::string>& names) {
    for (std::size_t i = 0; i < decoded_.size(); ++i) {
      json& views = document_.json["bufferViews"];
      json& accessors = document_.json["accessors"];
      const std::size_t length = decoded_[i].bytes.size();
      const std::size_t buffer = document_.add_buffer(std::move(decoded_[i].bytes));
      decoded_[i].accessor["bufferView"] = views.size();
      views.push_back({{"buffer", buffer}, {"byteLength", length}});
      (i == 0 ? primitive["indices"] : primitive["attributes"][names[i - 1]]) = accessors.size();
      accessors.push_back(std::move(decoded_[i].accessor));
    }
    primitive["mode"] = 4;  // the decoder turns strips into triangles
  }

  GltfDocument& document_;
  LoadBudget& budget_;
  std::string place_;
  std::vector<Decoded> decoded_;
};

// Does every accessor of the primitive have data without the extension?
bool has_fallback(const GltfDocument& document, const json& primitive) {
  const auto stored = [&](const json& number) {
    return document.json["accessors"].at(number.get<std::size_t>()).contains("bufferView");
  };
  const json& attributes = primitive.at("attributes");
  return std::all_of(attributes.begin(), attributes.end(), stored) &&
         (!primitive.contains("indices") || stored(primitive["indices"]));
}

}  // namespace

void decode_draco(GltfDocument& document, LoadBudget& budget) {
  if (!document.json.contains("meshes")) {
    return;
  }
  json& meshes = document.json["meshes"];
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    json& primitives = meshes[m]["primitives"];
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const std::string place = fmt::format("meshes[{}]: primitives[{}]", m, p);
      auto extension = document.extension(primitives[p], "KHR_draco_mesh_compression", place);
      if (!extension) {
        continue;
      }
      const auto fail = [&](const std::string& why) {
        if (!has_fallback(document, primitives[p])) {
          throw LoadError(document.file, place, "Draco: " + why);
        }
        document.warnings.push_back(
            fmt::format("{}: Draco: {}; uncompressed data is read", place, why));
      };
      try {
        PrimitiveDecoder(document, budget, place).decode(primitives[p], *extension);
      } catch (const LoadError&) {
        throw;
      } catch (const std::bad_alloc&) {
        fail("is too large");
      } catch (const std::exception& error) {
        fail(error.what());
      }
    }
  }
}

}  // namespace raycat
