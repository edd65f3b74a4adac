#include "io/images/png_decode.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include <catch2/catch.hpp>
#include <png.h>

namespace raycat {
namespace {

DecodedImage decode(std::span<const std::uint8_t> bytes) {
  return decode_png(bytes, [](std::uint32_t width, std::uint32_t height) {
    return DecodedImage{.width = width,
                        .height = height,
                        .rgba = std::vector<std::uint8_t>(std::size_t{4} * width * height)};
  });
}

// The bytes of a PNG of one row, as libpng writes it.
std::vector<std::uint8_t> row(png_uint_32 format, png_uint_32 width, const void* samples,
                              const void* colours = nullptr, png_uint_32 colour_count = 0) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = width;
  image.height = 1;
  image.format = format;
  image.colormap_entries = colour_count;
  png_alloc_size_t size = 0;
  REQUIRE(png_image_write_to_memory(&image, nullptr, &size, 0, samples, 0, colours) != 0);
  std::vector<std::uint8_t> bytes(size);
  REQUIRE(png_image_write_to_memory(&image, bytes.data(), &size, 0, samples, 0, colours) != 0);
  bytes.resize(size);
  return bytes;
}

TEST_CASE("16 bits are rounded to 8, and gamma is passed over", "[io][image][png]") {
  // 257 to a step: halfway is between 128 and 129, and between 32767 and 32768.
  const std::array<std::uint16_t, 6> greys{0, 128, 129, 32767, 32768, 65535};
  const DecodedImage image = decode(row(PNG_FORMAT_LINEAR_Y, 6, greys.data()));
  const std::array<std::uint8_t, 6> expected{0, 0, 1, 127, 128, 255};
  REQUIRE(image.rgba.size() == 24);
  for (std::size_t i = 0; i < 6; ++i) {
    INFO(i);
    CHECK(image.rgba[4 * i] == expected[i]);
    CHECK(image.rgba[4 * i + 2] == expected[i]);
    CHECK(image.rgba[4 * i + 3] == 255);
  }
}

TEST_CASE("grey with alpha and palettes with alpha are straight RGBA", "[io][image][png]") {
  const std::array<std::uint8_t, 4> greys{90, 7, 200, 255};
  CHECK(decode(row(PNG_FORMAT_GA, 2, greys.data())).rgba ==
        std::vector<std::uint8_t>{90, 90, 90, 7, 200, 200, 200, 255});
  const std::array<std::uint8_t, 8> colours{10, 20, 30, 255, 40, 50, 60, 70};
  const std::array<std::uint8_t, 3> indices{1, 0, 1};
  CHECK(decode(row(PNG_FORMAT_RGBA_COLORMAP, 3, indices.data(), colours.data(), 2)).rgba ==
        std::vector<std::uint8_t>{40, 50, 60, 70, 10, 20, 30, 255, 40, 50, 60, 70});
}

TEST_CASE("a PNG whose pixels are damaged is refused with libpng's reason", "[io][image][png]") {
  const std::array<std::uint8_t, 3> pixel{1, 2, 3};
  std::vector<std::uint8_t> bytes = row(PNG_FORMAT_RGB, 1, pixel.data());
  constexpr std::array<std::uint8_t, 4> name{'I', 'D', 'A', 'T'};
  const auto data = std::search(bytes.begin(), bytes.end(), name.begin(), name.end());
  REQUIRE(data != bytes.end());
  *(data + 8) ^= 0x55;
  CHECK_THROWS_WITH(decode(bytes), Catch::StartsWith("the PNG cannot be decoded: "));
}

}  // namespace
}  // namespace raycat
