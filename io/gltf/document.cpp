#include "io/gltf/document.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "io/files/excerpt.hpp"
#include "io/files/load_error.hpp"
#include "io/gltf/accessor.hpp"
#include "io/gltf/container.hpp"
#include "io/gltf/draco.hpp"
#include "io/gltf/meshopt.hpp"
#include "io/gltf/schema.hpp"
#include "io/gltf/uri.hpp"

namespace raycat {
namespace {

using nlohmann::json;

// Without what these say, triangles would be read wrongly or not at all.
constexpr auto read_extensions = std::to_array<std::string_view>({
    "CESIUM_primitive_outline",   "EXT_instance_features",
    "EXT_mesh_features",          "EXT_mesh_gpu_instancing",
    "EXT_mesh_polygon",           "EXT_meshopt_compression",
    "EXT_texture_webp",           "FB_ngon_encoding",
    "KHR_draco_mesh_compression", "KHR_implicit_shapes",
    "KHR_lights_punctual",        "KHR_materials_emissive_strength",
    "KHR_materials_ior",          "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_specular",     "KHR_materials_transmission",
    "KHR_materials_unlit",        "KHR_materials_volume",
    "KHR_mesh_quantization",      "KHR_meshopt_compression",
    "KHR_node_visibility",        "KHR_physics_rigid_bodies",
    "KHR_texture_transform",      "OMI_physics_body",
    "OMI_physics_shape",
});

// What these say changes nothing that can be seen or told apart.
constexpr auto silent_extensions = std::to_array<std::string_view>({
    "EXT_mesh_manifold",  // closed or not, and where, the triangles say themselves
    "EXT_structural_metadata",
    "KHR_interactivity",
    "KHR_node_hoverability",
    "KHR_node_selectability",
    "KHR_xmp_json_ld",
});

bool contains(const auto& range, std::string_view name) {
  return std::ranges::find(range, name) != std::end(range);
}

void check_version(const GltfDocument& document) {
  const auto& asset = document.json["asset"];
  const std::string version = asset["version"];
  const std::string least = asset.value("minVersion", version);
  if (!version.starts_with("2.") || (least != version && least != "2.0")) {
    throw LoadError(document.file, "asset",
                    fmt::format("glTF version {} is not supported, only 2.0",
                                excerpt(version.starts_with("2.") ? least : version)));
  }
}

// A material that is shaded without an extension is still seen; the rest must be understood.
void check_extensions(GltfDocument& document) {
  for (const std::string name : document.json.value("extensionsRequired", json::array())) {
    if (!contains(read_extensions, name) && !name.starts_with("KHR_materials_")) {
      throw LoadError(document.file, "extensionsRequired",
                      fmt::format("extension '{}' is required but not supported", excerpt(name)));
    }
  }
  std::string ignored;
  for (const std::string name : document.json.value("extensionsUsed", json::array())) {
    if (!contains(read_extensions, name) && !contains(silent_extensions, name)) {
      ignored += fmt::format("{}{}", ignored.empty() ? "" : ", ", excerpt(name));
    }
  }
  if (!ignored.empty()) {
    document.warnings.push_back("extensions that are ignored: " + ignored);
  }
}

void load_buffers(GltfDocument& document, const GltfContainer& container, LoadBudget& budget) {
  std::map<std::string, std::shared_ptr<const Bytes>> files;
  if (container.bytes) {
    document.storage.push_back(container.bytes);
  }
  const json buffers = document.json.value("buffers", json::array());
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    const auto fail = [&](const std::string& what) {
      throw LoadError(document.file, fmt::format("buffers[{}]", i), what);
    };
    const std::size_t length = buffers[i]["byteLength"];
    std::span<const std::uint8_t> bytes;
    if (const auto uri = buffers[i].find("uri"); uri != buffers[i].end()) {
      const auto& text = uri->get_ref<const std::string&>();
      auto& file = files[is_data_uri(text) ? fmt::format("data:{}", i) : text];
      try {
        if (!file) {
          file = std::make_shared<const Bytes>(
              read_uri(document.file.parent_path(), text, [&](std::uint64_t size) {
                budget.take_memory(document.file, fmt::format("buffers[{}]", i), size);
              }));
          document.storage.push_back(file);
        }
      } catch (const LoadError&) {
        throw;
      } catch (const std::runtime_error& error) {
        fail(is_data_uri(text) ? error.what()
                               : fmt::format("'{}': {}", excerpt(text), error.what()));
      }
      bytes = *file;
    } else if (i == 0 && container.has_binary) {
      bytes = container.binary;
    } else {
      // Data that an extension would make, or that no one reads: an error only when read.
      document.buffers.emplace_back();
      continue;
    }
    if (bytes.size() < length) {
      fail(fmt::format("{} bytes are declared, but there are {}", length, bytes.size()));
    }
    document.buffers.push_back(bytes.first(length));
  }
  // Data URIs have been decoded: their text is as large as all the rest.
  for (json& buffer :
       document.json.contains("buffers") ? document.json["buffers"] : json::array()) {
    buffer.erase("uri");
  }
}

// tinygltf gets what it reads well: no buffers, images, extensions or extras.
tinygltf::Model parse_model(const GltfDocument& document) {
  json kept;
  for (const char* key : {"asset", "scene", "scenes", "nodes", "meshes", "accessors", "bufferViews",
                          "materials", "textures", "samplers", "cameras"}) {
    const auto found = document.json.find(key);
    if (found == document.json.end()) {
      continue;
    }
    json& section = kept[key] = *found;
    for (auto& element : section.is_array() ? section : json::array()) {
      element.erase("extensions");
      element.erase("extras");
    }
  }
  tinygltf::TinyGLTF parser;
  tinygltf::Model model;
  std::string error;
  std::string warning;
  const std::string text = kept.dump();
  if (!parser.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                  static_cast<unsigned>(text.size()), "", tinygltf::NO_REQUIRE)) {
    throw LoadError(document.file, "glTF", excerpt(error));
  }
  return model;
}

void check_forest(GltfDocument& document) {
  const auto& nodes = document.model.nodes;
  document.parents.resize(nodes.size());
  for (std::size_t parent = 0; parent < nodes.size(); ++parent) {
    for (const int number : nodes[parent].children) {
      const auto child = static_cast<std::size_t>(number);
      if (document.parents[child]) {
        throw LoadError(
            document.file, document.node_place(child),
            fmt::format("has two parents, nodes {} and {}", *document.parents[child], parent));
      }
      document.parents[child] = parent;
    }
  }
  // With one parent each, nodes that no root leads to are on a cycle or below one.
  std::vector<bool> reached(nodes.size());
  std::vector<std::size_t> pending;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!document.parents[i]) {
      pending.push_back(i);
    }
  }
  while (!pending.empty()) {
    const std::size_t node = pending.back();
    pending.pop_back();
    reached[node] = true;
    pending.insert(pending.end(), nodes[node].children.begin(), nodes[node].children.end());
  }
  const auto lost = std::ranges::find(reached, false);
  if (lost != reached.end()) {
    throw LoadError(document.file,
                    document.node_place(static_cast<std::size_t>(lost - reached.begin())),
                    "the node is on or below a cycle of children");
  }
}

}  // namespace

std::string GltfDocument::node_place(std::size_t node) const {
  return raycat::node_place(json, node);
}

std::string GltfDocument::node_name(std::size_t node) const {
  const std::string& name = model.nodes[node].name;
  return name.empty() ? fmt::format("node {}", node) : name;
}

std::optional<JsonFields> GltfDocument::extension(const nlohmann::json& object,
                                                  const std::string& name,
                                                  const std::string& place) const {
  const auto extensions = object.find("extensions");
  if (extensions == object.end() || !extensions->is_object() || !extensions->contains(name)) {
    return std::nullopt;
  }
  return JsonFields(file, place, name, extensions->at(name));
}

std::span<const std::uint8_t> GltfDocument::view_bytes(std::size_t view) const {
  const auto& of = model.bufferViews[view];
  const auto buffer = buffers[static_cast<std::size_t>(of.buffer)];
  return buffer.empty() ? buffer : buffer.subspan(of.byteOffset, of.byteLength);
}

std::span<const std::uint8_t> GltfDocument::slice(std::size_t buffer, std::size_t offset,
                                                  std::size_t length,
                                                  const std::string& place) const {
  if (buffer >= buffers.size()) {
    throw LoadError(
        file, place,
        fmt::format("there is no buffers[{}]; the file has {}", buffer, buffers.size()));
  }
  const auto bytes = buffers[buffer];
  if (bytes.empty()) {
    throw LoadError(file, place, fmt::format("is of buffers[{}], which has no data", buffer));
  }
  if (length > bytes.size() || offset > bytes.size() - length) {
    throw LoadError(file, place,
                    fmt::format("{} bytes from {} overrun the {} of buffers[{}]", length, offset,
                                bytes.size(), buffer));
  }
  return bytes.subspan(offset, length);
}

std::span<const std::uint8_t> GltfDocument::json_view_bytes(std::size_t view) const {
  const auto& of = json["bufferViews"][view];
  return slice(of["buffer"], of.value("byteOffset", std::size_t{0}), of["byteLength"],
               fmt::format("bufferViews[{}]", view));
}

std::size_t GltfDocument::add_buffer(Bytes bytes) {
  storage.push_back(std::make_shared<const Bytes>(std::move(bytes)));
  buffers.emplace_back(*storage.back());
  json["buffers"].push_back({{"byteLength", buffers.back().size()}});
  return buffers.size() - 1;
}

Bytes GltfDocument::image_bytes(std::size_t image, LoadBudget& budget) const {
  const auto reserve = [&](std::uint64_t size) {
    budget.take_memory(file, fmt::format("images[{}]", image), size);
  };
  const auto& of = json["images"][image];
  if (const auto uri = of.find("uri"); uri != of.end()) {
    return read_uri(file.parent_path(), uri->get_ref<const std::string&>(), reserve);
  }
  if (const auto view = of.find("bufferView"); view != of.end()) {
    const auto bytes = view_bytes(view->get<std::size_t>());
    reserve(bytes.size());
    return {bytes.begin(), bytes.end()};
  }
  throw std::runtime_error("has neither a URI nor a buffer view");
}

GltfDocument open_gltf(const std::filesystem::path& file, LoadBudget& budget) {
  GltfDocument document;
  document.file = file;
  {
    const SpentTime parsing(budget.spent().parse);
    GltfContainer container = open_container(file, budget);
    document.json = std::move(container.json);
    document.warnings = std::move(container.warnings);
    check_schema(file, document.json);
    check_version(document);
    check_extensions(document);
    budget.check_nodes(file, document.json.value("nodes", json::array()).size());
    load_buffers(document, container, budget);
  }
  {
    const SpentTime decompressing(budget.spent().decompress);
    decode_meshopt(document, budget);
    decode_draco(document, budget);
  }
  const SpentTime parsing(budget.spent().parse);
  document.model = parse_model(document);
  check_accessors(document, budget);
  check_forest(document);
  return document;
}

}  // namespace raycat
