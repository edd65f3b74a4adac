#include "io/images/image_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <glm/vec4.hpp>

#include "io/files/input_file.hpp"
#include "io/files/output_file.hpp"
#include "io/images/attributes.hpp"
#include "tracer/srgb.hpp"

namespace raycat {
namespace {

namespace fs = std::filesystem;

// The name of OpenImageIO's format for a path; empty if there is none.
std::string_view format_of(const fs::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".png") {
    return "png";
  }
  if (extension == ".exr") {
    return "openexr";
  }
  if (extension == ".ppm") {
    return "pnm";
  }
  std::error_code ignored;
  return fs::is_character_file(path, ignored) ? "png" : "";
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

std::vector<glm::vec4> with_alpha(const Image& image) {
  std::vector<glm::vec4> pixels;
  pixels.reserve(image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    pixels.emplace_back(image.pixels[i], image.alpha[i]);
  }
  return pixels;
}

std::string one_line(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20; }, ' ');
  return text;
}

// OpenImageIO writes no comments into PPM files, so they are put behind the magic number.
void add_comments(std::vector<unsigned char>& file, const Provenance& from) {
  std::string comments =
      fmt::format("# {}\n# scene {}\n", one_line(from.command), one_line(from.scene));
  if (!from.legend.empty()) {
    comments += fmt::format("# {}\n", one_line(from.legend));
  }
  file.insert(file.begin() + 3, comments.begin(), comments.end());
}

}  // namespace

void describe(const Provenance& provenance, bool linear, OIIO::ImageSpec& spec) {
  spec.attribute("oiio:ColorSpace", linear ? "linear" : "sRGB");
  spec.attribute("Software", one_line(provenance.command));
  spec.attribute("ImageDescription", one_line(fmt::format("scene {}", provenance.scene)));
  if (!provenance.legend.empty()) {
    spec.attribute("Legend", one_line(provenance.legend));
  }
  if (linear) {
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "1970:01:01 00:00:00");  // or the time of day makes files differ
  }
}

void require_image_path(const fs::path& path) {
  if (format_of(path).empty()) {
    throw std::invalid_argument(fmt::format("{}: images end in .png, .exr or .ppm", path.string()));
  }
}

bool holds_alpha(const fs::path& path) { return format_of(path) != "pnm"; }

void write_image(const fs::path& path, const Image& image, const Provenance& provenance) {
  require_image_path(path);
  const std::string format(format_of(path));
  const bool linear = format == "openexr";
  const auto output = OIIO::ImageOutput::create(format);
  if (!output) {
    throw std::runtime_error(fmt::format("{}: OpenImageIO cannot write {}", path.string(), format));
  }
  const bool alpha = !image.alpha.empty() && holds_alpha(path);
  OIIO::ImageSpec spec(image.width, image.height, alpha ? 4 : 3,
                       linear ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
  describe(provenance, linear, spec);
  if (alpha && !linear) {
    spec.attribute("oiio:UnassociatedAlpha", 1);
  }

  std::vector<unsigned char> file;
  OIIO::Filesystem::IOVecOutput memory(file);
  const std::vector<std::uint8_t> bytes =
      linear ? std::vector<std::uint8_t>() : to_bytes(image, alpha);
  const std::vector<glm::vec4> associated =
      linear && alpha ? with_alpha(image) : std::vector<glm::vec4>();
  const void* pixels = !linear ? static_cast<const void*>(bytes.data())
                       : alpha ? static_cast<const void*>(associated.data())
                               : image.pixels.data();
  if (!output->set_ioproxy(&memory) || !output->open("image." + format, spec) ||
      !output->write_image(spec.format, pixels) || !output->close()) {
    throw std::runtime_error(fmt::format("{}: {}", path.string(), output->geterror()));
  }
  if (format == "pnm") {
    add_comments(file, provenance);
  }
  write_file(path, std::as_bytes(std::span(file)));
}

}  // namespace raycat
