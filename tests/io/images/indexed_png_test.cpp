#include "io/images/indexed_png.hpp"

#include <cstdio>
#include <map>
#include <memory>

#include <catch2/catch.hpp>
#include <png.h>

#include "support/png_pixels.hpp"
#include "support/temporary_folder.hpp"

namespace raycat {
namespace {

namespace fs = std::filesystem;
using Srgb = std::array<std::uint8_t, 3>;

// What a program finds that reads the file's indices.
struct Found {
  int width = 0;
  int height = 0;
  int bits = 0;
  bool palette_kind = false;
  std::vector<std::uint8_t> pixels;
  std::vector<Srgb> palette;
  std::map<std::string, std::string> texts;
};

Found read(const fs::path& path) {
  const auto fail = [](png_structp, png_const_charp message) { throw std::runtime_error(message); };
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, fail);
  png_infop info = png_create_info_struct(png);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             std::fclose);
  REQUIRE(file);
  png_init_io(png, file.get());
  png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  Found found{.width = static_cast<int>(png_get_image_width(png, info)),
              .height = static_cast<int>(png_get_image_height(png, info)),
              .bits = png_get_bit_depth(png, info),
              .palette_kind = png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE};
  const png_bytepp rows = png_get_rows(png, info);
  for (int y = 0; y < found.height; ++y) {
    found.pixels.insert(found.pixels.end(), rows[y], rows[y] + found.width);
  }
  png_colorp colours = nullptr;
  int count = 0;
  png_get_PLTE(png, info, &colours, &count);
  for (int i = 0; i < count; ++i) {
    found.palette.push_back({colours[i].red, colours[i].green, colours[i].blue});
  }
  png_textp texts = nullptr;
  png_get_text(png, info, &texts, &count);
  for (int i = 0; i < count; ++i) {
    found.texts[texts[i].key] = texts[i].text;
  }
  png_destroy_read_struct(&png, &info, nullptr);
  return found;
}

std::vector<Srgb> greys(int count) {
  std::vector<Srgb> palette;
  for (int i = 0; i < count; ++i) {
    const auto grey = static_cast<std::uint8_t>(255 - i);
    palette.push_back({grey, static_cast<std::uint8_t>(i), 7});
  }
  return palette;
}

const Provenance from{
    .command = "raycat render s.gltf", .scene = "Łódź.gltf", .legend = "1 object, 2 primitive"};

TEST_CASE("indices, palette and texts come back as they were written", "[io][indexed]") {
  const TemporaryFolder folder;
  const IndexedImage image{.width = 3, .height = 2, .pixels = {0, 63, 2, 63, 1, 0}};
  write_indexed_png(folder / "a.png", image, greys(64), from);
  const Found found = read(folder / "a.png");
  CHECK(found.width == 3);
  CHECK(found.height == 2);
  CHECK(found.bits == 8);
  CHECK(found.palette_kind);
  CHECK(found.pixels == image.pixels);
  CHECK(found.palette == greys(64));
  CHECK(found.texts == std::map<std::string, std::string>{{"Software", "raycat render s.gltf"},
                                                          {"Description", "scene Łódź.gltf"},
                                                          {"Legend", "1 object, 2 primitive"}});
  CHECK(folder.files() == 1);
}

TEST_CASE("two colours and 256 take a byte a pixel alike", "[io][indexed]") {
  const TemporaryFolder folder;
  const int colours = GENERATE(2, 256);
  IndexedImage image{.width = 1000, .height = 300};
  for (int i = 0; i < 1000 * 300; ++i) {
    image.pixels.push_back(static_cast<std::uint8_t>((i + i / 7) % colours));
  }
  write_indexed_png(folder / "b.PNG", image, greys(colours), from);
  const Found found = read(folder / "b.PNG");
  CHECK(found.bits == 8);
  CHECK(found.pixels == image.pixels);
}

TEST_CASE("a viewer sees the palette's colours, and where an image is from", "[io][indexed]") {
  const TemporaryFolder folder;
  write_indexed_png(folder / "a.png", {.width = 2, .height = 1, .pixels = {1, 0}},
                    std::vector<Srgb>{{230, 159, 0}, {30, 31, 32}}, from);
  CHECK(png_pixels(folder / "a.png").bytes == std::vector<std::uint8_t>{30, 31, 32, 230, 159, 0});
  const Found found = read(folder / "a.png");
  CHECK(found.texts.at("Software") == "raycat render s.gltf");
  CHECK(found.texts.at("Description") == "scene Łódź.gltf");
  CHECK(found.texts.at("Legend") == "1 object, 2 primitive");
}

TEST_CASE("one image is always the same bytes", "[io][indexed]") {
  const TemporaryFolder folder;
  const IndexedImage image{.width = 2, .height = 2, .pixels = {0, 1, 1, 0}};
  write_indexed_png(folder / "a.png", image, greys(2), from);
  write_indexed_png(folder / "b.png", image, greys(2), from);
  const auto bytes = [](const fs::path& path) {
    std::vector<char> content(fs::file_size(path));
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                               std::fclose);
    content.resize(std::fread(content.data(), 1, content.size(), file.get()));
    return content;
  };
  CHECK(bytes(folder / "a.png") == bytes(folder / "b.png"));
  CHECK(bytes(folder / "a.png").size() > 60);
}

TEST_CASE("what cannot be an indexed image leaves nothing and says why", "[io][indexed]") {
  const TemporaryFolder folder;
  const IndexedImage image{.width = 1, .height = 1, .pixels = {0}};
  const auto write = [&](const fs::path& path, const IndexedImage& what) {
    write_indexed_png(path, what, greys(2), from);
  };
  CHECK_THROWS_WITH(write(folder / "none/a.png", image),
                    (folder / "none/a.png") + ": cannot write: No such file or directory");
  CHECK_THROWS_WITH(write(folder / "a.exr", image),
                    (folder / "a.exr") + ": indexed images end in .png");
  // libpng's own errors come back too.
  CHECK_THROWS_WITH(write(folder / "a.png", {.width = 0, .height = 0, .pixels = {}}),
                    Catch::StartsWith((folder / "a.png") + ": ") && Catch::Contains("IHDR"));
  CHECK(folder.files() == 0);
  CHECK_THROWS_WITH(write("/dev/full", image), "/dev/full: cannot write: No space left on device");
}

TEST_CASE("only PNG and devices take indexed images", "[io][indexed]") {
  CHECK_NOTHROW(require_indexed_path("A.PNG"));
  CHECK_NOTHROW(require_indexed_path("/dev/null"));
  CHECK_THROWS_WITH(require_indexed_path("a.ppm"), "a.ppm: indexed images end in .png");
  CHECK_THROWS_AS(require_indexed_path("png"), std::invalid_argument);
}

}  // namespace
}  // namespace raycat
