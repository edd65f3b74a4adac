#include "io/images/decode.hpp"

#include <stdexcept>

#include <catch2/catch.hpp>

#include "tests/io/images/png_file.hpp"

namespace raycat {
namespace {

DecodedImage decode(std::string_view bytes, std::uint64_t max_pixels) {
  const std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
  return decode_image(copy, max_pixels);
}

TEST_CASE("an image without alpha is opaque", "[io][image]") {
  Image image(2, 1, glm::vec3(1.0f));
  image.pixels[1] = {1.0f, 0.0f, 0.0f};
  const DecodedImage is = decode(png(image), 2);
  CHECK(is.width == 2);
  CHECK(is.height == 1);
  CHECK(is.rgba == std::vector<std::uint8_t>{255, 255, 255, 255, 255, 0, 0, 255});
}

TEST_CASE("an image with one pixel too many is refused", "[io][image]") {
  const std::string bytes = png(Image(2, 3));
  CHECK_NOTHROW(decode(bytes, 6));
  CHECK_THROWS_WITH(decode(bytes, 5), "2 x 3 pixels are more than the 5 allowed");
}

TEST_CASE("the limit on pixels holds by the header, before anything is decoded", "[io][image]") {
  const std::string bytes = claimed(png(Image(2, 3)), 30000, 30000);
  CHECK_THROWS_WITH(decode(bytes, 1 << 26),
                    "30000 x 30000 pixels are more than the 67108864 allowed");
}

// 3 x 2 pixels of one colour, without loss.
const std::string webp(
    "RIFF\x1c\0\0\0WEBPVP8L\x0f\0\0\0\x2f\x02\x40\x00\x10\x07\x90\xfd\x8f\x02\x06\x22\xa2\xff\x01"
    "\0",
    36);

TEST_CASE("a WebP image is read, if its header promises few pixels", "[io][image]") {
  const DecodedImage is = decode(webp, 6);
  CHECK(is.width == 3);
  CHECK(is.height == 2);
  CHECK(is.rgba.size() == 24);
  CHECK(is.rgba[0] == 255);
  CHECK(is.rgba[2] == 0);
  CHECK(is.rgba[3] == 128);
  CHECK_THROWS_WITH(decode(webp, 5), "6 pixels are more than the 5 allowed");
  std::string bomb = webp;
  bomb.replace(21, 4, "\xff\xff\xff\x0f");
  CHECK_THROWS_WITH(decode(bomb, 1 << 26), "268435456 pixels are more than the 67108864 allowed");
  CHECK_THROWS_AS(decode(webp.substr(0, 30), 100), std::runtime_error);
}

TEST_CASE("what is no image is refused", "[io][image]") {
  CHECK_THROWS_WITH(decode("GIF89a", 100), "neither PNG, JPEG nor WebP");
  CHECK_THROWS_WITH(decode("", 100), "neither PNG, JPEG nor WebP");
  const std::string whole = png(Image(2, 3));
  CHECK_THROWS_WITH(decode(whole.substr(0, 8), 100), "the PNG has no pixels");
  CHECK_THROWS_WITH(decode(whole.substr(0, 33), 100), "the PNG has no pixels");
  CHECK_THROWS_WITH(decode(whole.substr(0, 40), 100), "the PNG breaks off");
}

}  // namespace
}  // namespace raycat
