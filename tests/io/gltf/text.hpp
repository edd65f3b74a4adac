#pragma once

#include <bit>
#include <cstdint>
#include <initializer_list>
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

/// Numbers as accessors of component type 5126 hold them.
inline std::string floats(std::initializer_list<float> numbers) {
  std::string bytes;
  for (const float number : numbers) {
    bytes += le32(std::bit_cast<std::uint32_t>(number));
  }
  return bytes;
}

/// A URI that holds `bytes`, whatever they are.
inline std::string data_uri(std::string_view bytes) {
  std::string uri = "data:application/octet-stream,";
  for (const char byte : bytes) {
    constexpr std::string_view digits = "0123456789abcdef";
    const auto value = static_cast<unsigned char>(byte);
    uri += {'%', digits[value / 16], digits[value % 16]};
  }
  return uri;
}

/// A section of one buffer that holds `bytes`.
inline std::string buffer_of(std::string_view bytes) {
  return R"("buffers":[{"byteLength":)" + std::to_string(bytes.size()) + R"(,"uri":")" +
         data_uri(bytes) + R"("}])";
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
