#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "tests/io/scene_text.hpp"

namespace raycat {

/// A glTF document with one scene of `roots` and the given nodes, and more sections after them.
inline std::string gltf(std::string_view roots, std::string_view nodes,
                        std::string_view more = "") {
  return std::string(R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[)") + std::string(roots) +
         R"(]}],"nodes":[)" + std::string(nodes) + "]" + std::string(more) + "}";
}

/// The error of a document, without the file's name.
inline std::string gltf_error(std::string_view document) {
  const std::string prefix = "scene.gltf: ";
  const std::string message = load_error("scene.gltf", document);
  return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
}

/// Four bytes, the lowest first, as GLB counts.
inline std::string le32(std::uint32_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>(static_cast<unsigned char>(value >> shift));
  }
  return bytes;
}

inline std::string glb_chunk(std::string_view type, std::string_view content) {
  return le32(static_cast<std::uint32_t>(content.size())) + std::string(type) +
         std::string(content);
}

inline std::string glb(std::string_view chunks) {
  return "glTF" + le32(2) + le32(static_cast<std::uint32_t>(12 + chunks.size())) +
         std::string(chunks);
}

}  // namespace raycat
