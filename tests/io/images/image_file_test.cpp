#include "io/images/image_file.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <OpenImageIO/imageio.h>
#include <catch2/catch.hpp>
#include <unistd.h>

namespace raycat {
namespace {

namespace fs = std::filesystem;

fs::path temporary(const std::string& name) {
  return fs::temp_directory_path() / (std::to_string(::getpid()) + name);
}

Image two_pixels() {
  Image image(2, 1);
  image.pixels = {{0.0f, 0.5f, 1.0f}, {-1.0f, 0.2158605f, 7.5f}};
  return image;
}

TEST_CASE("eight bits hold sRGB, and what they cannot show is cut off", "[io][image]") {
  const fs::path path = temporary(GENERATE("a.png", "a.ppm"));
  write_image(path, two_pixels(), {.command = "raycat render", .scene = "s.gltf"});
  const auto input = OIIO::ImageInput::open(path.string());
  REQUIRE(input);
  std::vector<std::uint8_t> bytes(6);
  REQUIRE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, bytes.data()));
  // Linear 0.5 is 188 in sRGB, and 0.2159 is 128.
  CHECK(bytes == std::vector<std::uint8_t>{0, 188, 255, 0, 128, 255});
  fs::remove(path);
}

TEST_CASE("EXR holds linear light as it is", "[io][image]") {
  const fs::path path = temporary("a.exr");
  write_image(path, two_pixels(), {.command = "raycat render x", .scene = "s.gltf"});
  const auto input = OIIO::ImageInput::open(path.string());
  REQUIRE(input);
  std::vector<float> values(6);
  REQUIRE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, values.data()));
  CHECK(values == std::vector<float>{0.0f, 0.5f, 1.0f, -1.0f, 0.2158605f, 7.5f});
  CHECK(input->spec().get_string_attribute("Software") == "raycat render x");
  CHECK(input->spec().get_string_attribute("ImageDescription") == "scene s.gltf");
  fs::remove(path);
}

TEST_CASE("alpha is straight in PNG and associated in EXR", "[io][image]") {
  Image image(3, 1);
  image.pixels = {{0.5f, 0.25f, 0.0f}, {0.0f, 0.0f, 0.0f}, {1.0f, 0.5f, 0.0f}};
  image.alpha = {0.5f, 0.0f, 1.0f};
  const fs::path png = temporary("alpha.png");
  write_image(png, image, {.command = "raycat render", .scene = "s.gltf"});
  OIIO::ImageSpec as_stored;
  as_stored.attribute("oiio:UnassociatedAlpha", 1);
  auto input = OIIO::ImageInput::open(png.string(), &as_stored);
  REQUIRE(input);
  REQUIRE(input->spec().nchannels == 4);
  std::vector<std::uint8_t> bytes(12);
  REQUIRE(input->read_image(0, 0, 0, 4, OIIO::TypeDesc::UINT8, bytes.data()));
  CHECK(bytes == std::vector<std::uint8_t>{255, 188, 0, 128, 0, 0, 0, 0, 255, 188, 0, 255});
  const fs::path exr = temporary("alpha.exr");
  write_image(exr, image, {.command = "raycat render", .scene = "s.gltf"});
  input = OIIO::ImageInput::open(exr.string());
  REQUIRE(input);
  std::vector<float> values(12);
  REQUIRE(input->read_image(0, 0, 0, 4, OIIO::TypeDesc::FLOAT, values.data()));
  CHECK(values == std::vector<float>{0.5f, 0.25f, 0, 0.5f, 0, 0, 0, 0, 1, 0.5f, 0, 1});
  CHECK_FALSE(holds_alpha("a.ppm"));
  fs::remove(png);
  fs::remove(exr);
}

TEST_CASE("alpha beyond what bytes show is cut off, as filters may make it", "[io][image]") {
  Image image(2, 1);
  image.pixels = {{1.04f, 1.04f, 1.04f}, {-0.02f, -0.02f, -0.02f}};
  image.alpha = {1.04f, -0.02f};
  const fs::path path = temporary("beyond.png");
  write_image(path, image, {.command = "raycat render", .scene = "s.gltf"});
  OIIO::ImageSpec as_stored;
  as_stored.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(path.string(), &as_stored);
  REQUIRE(input);
  std::vector<std::uint8_t> bytes(8);
  REQUIRE(input->read_image(0, 0, 0, 4, OIIO::TypeDesc::UINT8, bytes.data()));
  CHECK(bytes == std::vector<std::uint8_t>{255, 255, 255, 255, 0, 0, 0, 0});
  fs::remove(path);
}

TEST_CASE("a line end in a name does not end a comment", "[io][image]") {
  const fs::path path = temporary("b.ppm");
  write_image(path, two_pixels(), {.command = "raycat\n1 1", .scene = "a\nb"});
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  CHECK(text.str().starts_with("P6\n# raycat 1 1\n# scene a b\n2 1\n255\n"));
  fs::remove(path);
}

TEST_CASE("an image of no known kind is refused", "[io][image]") {
  CHECK_THROWS_WITH(require_image_path("a.gif"), "a.gif: images end in .png, .exr or .ppm");
  CHECK_THROWS_AS(require_image_path("png"), std::invalid_argument);
  CHECK_NOTHROW(require_image_path("A.PNG"));
}

}  // namespace
}  // namespace raycat
