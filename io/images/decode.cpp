#include "io/images/decode.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "io/images/jpeg_decode.hpp"
#include "io/images/png_decode.hpp"
#include "io/images/webp_decode.hpp"

namespace raycat {
namespace {

bool has(std::span<const std::uint8_t> bytes, std::size_t at, std::string_view magic) {
  return bytes.size() >= at + magic.size() &&
         std::ranges::equal(bytes.subspan(at, magic.size()), magic, {}, {},
                            [](char c) { return static_cast<std::uint8_t>(c); });
}

}  // namespace

DecodedImage decode_image(std::span<const std::uint8_t> bytes, std::uint64_t max_pixels,
                          const std::function<void(std::uint64_t bytes)>& reserve) {
  const bool webp = has(bytes, 0, "RIFF") && has(bytes, 8, "WEBP");
  const MakeRoom make_room = [&](std::uint32_t width, std::uint32_t height) {
    const std::uint64_t pixels = std::uint64_t{width} * height;
    if (pixels == 0) {
      throw std::runtime_error("has no pixels");
    }
    if (pixels > max_pixels) {
      throw std::runtime_error(fmt::format(
          "{} pixels are more than the {} allowed",
          webp ? fmt::format("{}", pixels) : fmt::format("{} x {}", width, height), max_pixels));
    }
    reserve(4 * pixels);
    return DecodedImage{
        .width = width, .height = height, .rgba = std::vector<std::uint8_t>(4 * pixels)};
  };
  if (has(bytes, 0, "\x89PNG\r\n\x1a\n")) {
    return decode_png(bytes, make_room);
  }
  if (has(bytes, 0, "\xff\xd8\xff")) {
    return decode_jpeg(bytes, make_room);
  }
  if (webp) {
    return decode_webp(bytes, make_room);
  }
  throw std::runtime_error("neither PNG, JPEG nor WebP");
}

}  // namespace raycat
