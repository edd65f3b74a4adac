#include "io/image_decode.hpp"

#include <catch2/catch.hpp>

#include "tests/io/png_file.hpp"

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

TEST_CASE("what is no image is refused", "[io][image]") {
  CHECK_THROWS_WITH(decode("GIF89a", 100), "neither PNG nor JPEG");
  CHECK_THROWS_WITH(decode("", 100), "neither PNG nor JPEG");
  const std::string whole = png(Image(2, 3));
  CHECK_THROWS_WITH(decode(whole.substr(0, 8), 100), "the PNG has no pixels");
  CHECK_THROWS_WITH(decode(whole.substr(0, 33), 100), "the PNG has no pixels");
  CHECK_THROWS_WITH(decode(whole.substr(0, 40), 100), "the PNG breaks off");
}

}  // namespace
}  // namespace raycat
