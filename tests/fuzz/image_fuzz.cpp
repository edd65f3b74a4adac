// Images as textures, PNG, JPEG and WebP, and PNGs as OpenSCAD's height maps.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>

#include "io/images/decode.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::uint64_t most_pixels = std::uint64_t{1} << 20;
  try {
    const raycat::DecodedImage image = raycat::decode_image({data, size}, most_pixels);
    const std::uint64_t pixels = std::uint64_t{image.width} * image.height;
    if (pixels > most_pixels || image.rgba.size() != 4 * pixels) {
      std::abort();
    }
  } catch (const std::runtime_error&) {
  }
  return 0;
}
