#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace raycat {

/// 8-bit straight RGBA in row order from the top left.
struct DecodedImage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Makes room, all zero, for an image of the size that a file's header promises, or throws if that
/// is too much. Decoders take nothing of that size before.
using MakeRoom = std::function<DecodedImage(std::uint32_t width, std::uint32_t height)>;

}  // namespace raycat
