#include "io/images/jpeg_decode.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include <catch2/catch.hpp>
// Needs <cstdio>.
#include <jpeglib.h>

namespace raycat {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Kind {
  J_COLOR_SPACE space = JCS_RGB;
  int channels = 3;
  bool progressive = false;
};

// A JPEG of 32 x 32 pixels, of which every one is `pixel`, or has noise added to it.
Bytes jpeg(const Kind& kind, const std::array<std::uint8_t, 4>& pixel, unsigned noise = 0) {
  constexpr unsigned side = 32;
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = side;
  jpeg.image_height = side;
  jpeg.input_components = kind.channels;
  jpeg.in_color_space = kind.space;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 100, TRUE);
  if (kind.progressive) {
    jpeg_simple_progression(&jpeg);
  }
  jpeg_start_compress(&jpeg, TRUE);
  unsigned state = 1;
  for (unsigned y = 0; y < side; ++y) {
    Bytes row;
    for (unsigned x = 0; x < side; ++x) {
      for (std::size_t c = 0; c < static_cast<std::size_t>(kind.channels); ++c) {
        state = state * 1664525u + 1013904223u;
        row.push_back(
            static_cast<std::uint8_t>(pixel[c] + (noise == 0 ? 0 : (state >> 16) % noise)));
      }
    }
    JSAMPROW start = row.data();
    jpeg_write_scanlines(&jpeg, &start, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  Bytes file(bytes, bytes + size);
  std::free(bytes);
  return file;
}

DecodedImage decode(const Bytes& bytes) {
  return decode_jpeg(bytes, [](std::uint32_t width, std::uint32_t height) {
    return DecodedImage{.width = width,
                        .height = height,
                        .rgba = std::vector<std::uint8_t>(std::size_t{4} * width * height)};
  });
}

std::vector<int> first_pixel(const Bytes& bytes) {
  const DecodedImage image = decode(bytes);
  REQUIRE(image.width == 32);
  REQUIRE(image.height == 32);
  return {image.rgba[0], image.rgba[1], image.rgba[2], image.rgba[3]};
}

TEST_CASE("grey JPEGs are grey, and colours are colours", "[io][image][jpeg]") {
  CHECK(first_pixel(jpeg({.space = JCS_GRAYSCALE, .channels = 1}, {77})) ==
        std::vector<int>{77, 77, 77, 255});
  const std::vector<int> red =
      first_pixel(jpeg({.progressive = GENERATE(false, true)}, {200, 40, 30}));
  CHECK(red[0] == Approx(200).margin(2));
  CHECK(red[1] == Approx(40).margin(2));
  CHECK(red[2] == Approx(30).margin(2));
  CHECK(red[3] == 255);
}

TEST_CASE("inks let light through each other", "[io][image][jpeg]") {
  // 200 * 128 / 255 is 100.4, and 100 * 128 / 255 is 50.2.
  CHECK(first_pixel(jpeg({.space = JCS_CMYK, .channels = 4}, {200, 100, 0, 128})) ==
        std::vector<int>{100, 50, 0, 255});
}

TEST_CASE("a JPEG without its end is read, and one without some pixels is not",
          "[io][image][jpeg]") {
  Bytes bytes = jpeg({}, {100, 100, 100}, 100);
  const DecodedImage whole = decode(bytes);
  bytes.resize(bytes.size() - 2);
  CHECK(decode(bytes).rgba == whole.rgba);
  bytes.resize(bytes.size() * 2 / 3);
  CHECK_THROWS_WITH(decode(bytes),
                    "the JPEG cannot be decoded: Corrupt JPEG data: premature end of "
                    "data segment");
  bytes.resize(200);
  CHECK_THROWS_AS(decode(bytes), std::runtime_error);
  bytes.resize(3);
  CHECK_THROWS_AS(decode(bytes), std::runtime_error);
}

TEST_CASE("a JPEG that is refined for ever is refused", "[io][image][jpeg]") {
  const Bytes bytes = jpeg({.progressive = true}, {100, 100, 100}, 100);
  constexpr std::array<std::uint8_t, 2> start{0xff, 0xda};
  const auto scan = std::find_end(bytes.begin(), bytes.end(), start.begin(), start.end());
  const auto end = bytes.end() - 2;
  REQUIRE(scan != bytes.end());
  Bytes many(bytes.begin(), scan);
  for (int i = 0; i < 1000; ++i) {
    many.insert(many.end(), scan, end);
  }
  many.insert(many.end(), end, bytes.end());
  CHECK_THROWS_WITH(decode(many), "the JPEG cannot be decoded: it has more than 100 scans");
}

}  // namespace
}  // namespace raycat
