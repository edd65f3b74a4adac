#include "io/images/image_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "io/files/input_file.hpp"
#include "io/files/output_file.hpp"
#include "io/images/exr_file.hpp"
#include "io/images/png_file.hpp"
#include "tracer/srgb.hpp"

namespace raycat {
namespace {

namespace fs = std::filesystem;

enum class Format { png, exr, ppm };

std::optional<Format> format_of(const fs::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".png") {
    return Format::png;
  }
  if (extension == ".exr") {
    return Format::exr;
  }
  if (extension == ".ppm") {
    return Format::ppm;
  }
  std::error_code ignored;
  return fs::is_character_file(path, ignored) ? std::optional(Format::png) : std::nullopt;
}

std::uint8_t to_byte(float share) {
  return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(share, 0.0f, 1.0f)));
}

std::uint8_t encoded(float light) {
  return to_byte(srgb_from_linear(std::clamp(light, 0.0f, 1.0f)));
}

std::vector<std::uint8_t> to_bytes(const Image& image, bool alpha) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve((alpha ? 4 : 3) * image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float share = alpha && image.alpha[i] > 0.0f ? image.alpha[i] : 1.0f;
    const glm::vec3 pixel = image.pixels[i] / share;
    bytes.insert(bytes.end(), {encoded(pixel.r), encoded(pixel.g), encoded(pixel.b)});
    if (alpha) {
      bytes.push_back(to_byte(image.alpha[i]));
    }
  }
  return bytes;
}

std::vector<std::byte> png_of(const Image& image, const Provenance& provenance) {
  const bool alpha = !image.alpha.empty();
  const std::vector<std::uint8_t> bytes = to_bytes(image, alpha);
  return png_file({.width = image.width,
                   .height = image.height,
                   .pixel = alpha ? PngPixel::rgba : PngPixel::rgb,
                   .bytes = bytes},
                  provenance);
}

std::vector<std::byte> exr_of(const Image& image, const Provenance& provenance) {
  static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
  std::vector<ExrChannel> channels;
  const auto* values = reinterpret_cast<const float*>(image.pixels.data());
  for (const char* name : {"R", "G", "B"}) {
    channels.push_back({.name = name, .first = values++, .stride = sizeof(glm::vec3)});
  }
  if (!image.alpha.empty()) {
    channels.push_back({.name = "A", .first = image.alpha.data()});
  }
  return exr_file(image.width, image.height, channels, provenance);
}

std::vector<std::byte> ppm_of(const Image& image, const Provenance& provenance) {
  std::string header = "P6\n";
  for (const auto& [keyword, text] : provenance_texts(provenance, "scene")) {
    header += fmt::format("# {}\n", text);
  }
  header += fmt::format("{} {}\n255\n", image.width, image.height);
  const std::vector<std::uint8_t> pixels = to_bytes(image, false);
  std::vector<std::byte> file(header.size() + pixels.size());
  std::ranges::copy(std::as_bytes(std::span(header)), file.begin());
  std::ranges::copy(std::as_bytes(std::span(pixels)),
                    file.begin() + static_cast<std::ptrdiff_t>(header.size()));
  return file;
}

}  // namespace

void require_image_path(const fs::path& path) {
  if (!format_of(path)) {
    throw std::invalid_argument(fmt::format("{}: images end in .png, .exr or .ppm", path.string()));
  }
}

bool holds_alpha(const fs::path& path) { return format_of(path) != Format::ppm; }

void write_image(const fs::path& path, const Image& image, const Provenance& provenance) {
  require_image_path(path);
  const Format format = *format_of(path);
  std::vector<std::byte> file;
  try {
    file = format == Format::png   ? png_of(image, provenance)
           : format == Format::exr ? exr_of(image, provenance)
                                   : ppm_of(image, provenance);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", path.string(), error.what()));
  }
  write_file(path, file);
}

}  // namespace raycat
