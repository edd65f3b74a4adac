#include "io/images/image_file.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "support/png_pixels.hpp"
#include "tests/io/images/exr_values.hpp"

namespace raycat {
namespace {

namespace fs = std::filesystem;

fs::path temporary(const std::string& name) {
  return fs::temp_directory_path() / (std::to_string(::getpid()) + name);
}

std::string text_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::vector<std::uint8_t> ppm_bytes(const fs::path& path) {
  const std::string text = text_of(path);
  const std::string last_of_header = "\n255\n";
  const std::size_t at = text.find(last_of_header);
  REQUIRE(at != std::string::npos);
  return {text.begin() + static_cast<std::ptrdiff_t>(at + last_of_header.size()), text.end()};
}

Image two_pixels() {
  Image image(2, 1);
  image.pixels = {{0.0f, 0.5f, 1.0f}, {-1.0f, 0.2158605f, 7.5f}};
  return image;
}

TEST_CASE("eight bits hold sRGB, and what they cannot show is cut off", "[io][image]") {
  const fs::path path = temporary(GENERATE("a.png", "a.ppm"));
  write_image(path, two_pixels(), {.command = "raycat render", .scene = "s.gltf"});
  const std::vector<std::uint8_t> bytes =
      path.extension() == ".png" ? png_pixels(path).bytes : ppm_bytes(path);
  // Linear 0.5 is 188 in sRGB, and 0.2159 is 128.
  CHECK(bytes == std::vector<std::uint8_t>{0, 188, 255, 0, 128, 255});
  fs::remove(path);
}

TEST_CASE("EXR holds linear light as it is", "[io][image]") {
  const fs::path path = temporary("a.exr");
  write_image(path, two_pixels(), {.command = "raycat render x", .scene = "s.gltf"});
  ExrValues exr(path);
  CHECK(exr.channels() == std::vector<std::string>{"B", "G", "R"});
  CHECK(exr.values<float>("R") == std::vector<float>{0.0f, -1.0f});
  CHECK(exr.values<float>("G") == std::vector<float>{0.5f, 0.2158605f});
  CHECK(exr.values<float>("B") == std::vector<float>{1.0f, 7.5f});
  CHECK(exr.text("Software") == "raycat render x");
  CHECK(exr.text("comments") == "scene s.gltf");
  fs::remove(path);
}

TEST_CASE("alpha is straight in PNG and associated in EXR", "[io][image]") {
  Image image(3, 1);
  image.pixels = {{0.5f, 0.25f, 0.0f}, {0.0f, 0.0f, 0.0f}, {1.0f, 0.5f, 0.0f}};
  image.alpha = {0.5f, 0.0f, 1.0f};
  const fs::path png = temporary("alpha.png");
  write_image(png, image, {.command = "raycat render", .scene = "s.gltf"});
  const PngPixels straight = png_pixels(png);
  CHECK(straight.alpha);
  CHECK(straight.bytes ==
        std::vector<std::uint8_t>{255, 188, 0, 128, 0, 0, 0, 0, 255, 188, 0, 255});
  const fs::path exr = temporary("alpha.exr");
  write_image(exr, image, {.command = "raycat render", .scene = "s.gltf"});
  ExrValues associated(exr);
  CHECK(associated.channels() == std::vector<std::string>{"A", "B", "G", "R"});
  CHECK(associated.values<float>("R") == std::vector<float>{0.5f, 0, 1});
  CHECK(associated.values<float>("G") == std::vector<float>{0.25f, 0, 0.5f});
  CHECK(associated.values<float>("B") == std::vector<float>{0, 0, 0});
  CHECK(associated.values<float>("A") == std::vector<float>{0.5f, 0, 1});
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
  CHECK(png_pixels(path).bytes == std::vector<std::uint8_t>{255, 255, 255, 255, 0, 0, 0, 0});
  fs::remove(path);
}

TEST_CASE("a line end in a name does not end a comment", "[io][image]") {
  const fs::path path = temporary("b.ppm");
  write_image(path, two_pixels(), {.command = "raycat\n1 1", .scene = "a\nb"});
  CHECK(text_of(path).starts_with("P6\n# raycat 1 1\n# scene a b\n2 1\n255\n"));
  fs::remove(path);
}

TEST_CASE("one picture is always the same bytes", "[io][image]") {
  const std::string extension = GENERATE(".png", ".exr", ".ppm");
  const fs::path a = temporary("a" + extension);
  const fs::path b = temporary("b" + extension);
  write_image(a, two_pixels(), {.command = "raycat render", .scene = "s.gltf"});
  write_image(b, two_pixels(), {.command = "raycat render", .scene = "s.gltf"});
  CHECK((text_of(a) == text_of(b)));
  CHECK(fs::file_size(a) > 6);
  fs::remove(a);
  fs::remove(b);
}

TEST_CASE("an image of no known kind is refused", "[io][image]") {
  CHECK_THROWS_WITH(require_image_path("a.gif"), "a.gif: images end in .png, .exr or .ppm");
  CHECK_THROWS_AS(require_image_path("png"), std::invalid_argument);
  CHECK_NOTHROW(require_image_path("A.PNG"));
}

}  // namespace
}  // namespace raycat
