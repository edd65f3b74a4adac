#include "io/images/webp_decode.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace raycat {
namespace {

DecodedImage decode(const std::string& text) {
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  return decode_webp(bytes, [](std::uint32_t width, std::uint32_t height) {
    return DecodedImage{.width = width,
                        .height = height,
                        .rgba = std::vector<std::uint8_t>(std::size_t{4} * width * height)};
  });
}

// 2 x 1 pixels without loss.
const std::string transparent(
    "RIFF\x22\0\0\0WEBPVP8L\x15\0\0\0\x2f\x01\0\0\x10\x0fp\n\xa8+\xf8\x9e\xc2"
    "c\0\x83\x16\x19\xd1\xff\0\0",
    42);

// Two images of 4 x 4 pixels, of the first of which only one is there, at (2, 2).
const std::string animated(
    "RIFF\x8a\0\0\0WEBPVP8X\n\0\0\0\x02\0\0\0\x03\0\0\x03\0\0"
    "ANIM\x06\0\0\0\0\0\0\0\0\0"
    "ANMF,\0\0\0\x01\0\0\x01\0\0\0\0\0\0\0\0\0\0\0\x02VP8L\x14\0\0\0/\0\0\0\0\x07P\x81T\x08 \0\n"
    "\x9a\xfe\xc7\x88\x88\xfe\x07"
    "ANMF*\0\0\0\0\0\0\0\0\0\x03\0\0\x03\0\0\0\0\0\0VP8L\x11\0\0\0/\x03\xc0\0\0\x07\xd0\x84&4\xa1"
    "\xff\x81\x88\xe8\x7f\0\0",
    146);

TEST_CASE("colours of a WebP are as they were, however little of them is seen",
          "[io][image][webp]") {
  CHECK(decode(transparent).rgba == std::vector<std::uint8_t>{200, 100, 50, 128, 10, 20, 30, 0});
}

TEST_CASE("the first image of an animated WebP is in its place", "[io][image][webp]") {
  const DecodedImage image = decode(animated);
  REQUIRE(image.width == 4);
  REQUIRE(image.height == 4);
  std::vector<std::uint8_t> expected;
  for (std::size_t i = 0; i < 16; ++i) {
    expected.insert(expected.end(), {0, 0, 0, 255});
  }
  expected[40] = 1;
  expected[41] = 2;
  expected[42] = 3;
  CHECK(image.rgba == expected);
}

TEST_CASE("a WebP that breaks off is refused wherever it does", "[io][image][webp]") {
  const std::string whole = GENERATE(transparent, animated);
  for (std::size_t size = 0; size + 1 < whole.size(); size += 5) {
    CHECK_THROWS_AS(decode(whole.substr(0, size)), std::runtime_error);
  }
}

}  // namespace
}  // namespace raycat
