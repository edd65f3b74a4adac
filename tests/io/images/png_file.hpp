#pragma once

#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "io/images/image_file.hpp"
#include "tests/io/scene_text.hpp"

namespace raycat {

/// The bytes of a PNG file of `image`.
inline std::string png(const Image& image) {
  const TemporaryFile file("image.png", "");
  write_image(file.path(), image, {});
  std::ifstream in(file.path(), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A PNG whose header is sound and says that it has `width` x `height` pixels.
inline std::string claimed(std::string bytes, std::uint32_t width, std::uint32_t height) {
  constexpr std::size_t header = 12;  // from the chunk's name, 17 bytes that the CRC covers
  constexpr std::size_t header_size = 17;
  const auto put = [&bytes](std::size_t at, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) {
      bytes[at++] = static_cast<char>(static_cast<unsigned char>(value >> shift));
    }
  };
  put(header + 4, width);
  put(header + 8, height);
  std::uint32_t crc = 0xffffffffu;
  for (const char byte : std::string_view(bytes).substr(header, header_size)) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
    }
  }
  put(header + header_size, ~crc);
  return bytes;
}

}  // namespace raycat
