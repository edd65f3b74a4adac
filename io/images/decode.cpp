#include "io/images/decode.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

namespace raycat {
namespace {

constexpr std::size_t webp_header = 30;  // up to the size that the first chunk tells

// OpenImageIO finds the decoder by this name.
const char* file_name(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view png = "\x89PNG\r\n\x1a\n";
  constexpr std::string_view jpeg = "\xff\xd8\xff";
  const auto starts_with = [bytes](std::string_view magic) {
    return bytes.size() >= magic.size() &&
           std::ranges::equal(bytes.first(magic.size()), magic, {}, {},
                              [](char c) { return static_cast<std::uint8_t>(c); });
  };
  if (starts_with(png)) {
    return "image.png";
  }
  if (starts_with(jpeg)) {
    return "image.jpg";
  }
  if (starts_with("RIFF") && bytes.size() >= webp_header &&
      std::ranges::equal(bytes.subspan(8, 4), std::string_view("WEBP"))) {
    return "image.webp";
  }
  throw std::runtime_error("neither PNG, JPEG nor WebP");
}

// The pixels that a WebP says it has, in its first chunk: OpenImageIO makes room for them as soon
// as it opens the file.
std::uint64_t webp_pixels(std::span<const std::uint8_t> bytes) {
  const auto number = [&](std::size_t at, std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = size; i-- > 0;) {
      value = value << 8 | bytes[at + i];
    }
    return value;
  };
  constexpr std::uint64_t fourteen_bits = 0x3fff;
  switch (bytes[15]) {
    case 'X':  // the canvas, less 1, in 24 bits each
      return (number(24, 3) + 1) * (number(27, 3) + 1);
    case 'L':  // after a signature, less 1, in 14 bits each
      return ((number(21, 4) & fourteen_bits) + 1) * ((number(21, 4) >> 14 & fourteen_bits) + 1);
    default:  // after a start code, in 14 bits each
      return (number(26, 2) & fourteen_bits) * (number(28, 2) & fourteen_bits);
  }
}

void require_few(std::uint64_t pixels, std::uint64_t most, const std::string& size) {
  if (pixels > most) {
    throw std::runtime_error(fmt::format("{} pixels are more than the {} allowed", size, most));
  }
}

// Throws unless every chunk is there to its end: where a PNG breaks off, libpng prints a line of
// its own and OpenImageIO loses memory.
void require_whole_png(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t signature = 8;
  constexpr std::size_t framing = 12;  // a chunk's length, type and checksum
  bool pixels = false;
  for (std::size_t at = signature; at < bytes.size();) {
    const std::span<const std::uint8_t> rest = bytes.subspan(at);
    if (rest.size() < framing) {
      throw std::runtime_error("the PNG breaks off");
    }
    const std::size_t length = std::size_t{rest[0]} << 24 | std::size_t{rest[1]} << 16 |
                               std::size_t{rest[2]} << 8 | std::size_t{rest[3]};
    if (length > rest.size() - framing) {
      throw std::runtime_error("the PNG breaks off");
    }
    const std::string type(rest.begin() + 4, rest.begin() + 8);
    if (type == "IEND") {
      break;
    }
    pixels = pixels || type == "IDAT";
    at += framing + length;
  }
  if (!pixels) {
    throw std::runtime_error("the PNG has no pixels");
  }
}

std::string reason(const std::string& error) {
  const auto line = error.substr(0, error.find('\n'));
  return line.empty() ? "cannot be decoded" : line;
}

// Where grey, grey with alpha, RGB or RGBA keeps its channels.
std::vector<std::uint8_t> expanded(const std::vector<std::uint8_t>& pixels, std::size_t count,
                                   std::size_t channels) {
  const bool coloured = channels >= 3;
  const bool transparent = channels == 2 || channels >= 4;
  std::vector<std::uint8_t> rgba(4 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* in = pixels.data() + channels * i;
    std::uint8_t* out = rgba.data() + 4 * i;
    out[0] = in[0];
    out[1] = in[coloured ? 1 : 0];
    out[2] = in[coloured ? 2 : 0];
    out[3] = transparent ? in[coloured ? 3 : 1] : std::uint8_t{255};
  }
  return rgba;
}

// Of premultiplied RGBA, which OpenImageIO makes of WebP whatever it is asked for.
void make_straight(std::vector<std::uint8_t>& rgba) {
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
    const unsigned alpha = rgba[i + 3];
    for (std::size_t c = i; c < i + 3 && alpha > 0; ++c) {
      rgba[c] = static_cast<std::uint8_t>(std::min(255u, (rgba[c] * 255u + alpha / 2) / alpha));
    }
  }
}

}  // namespace

DecodedImage decode_image(std::span<const std::uint8_t> bytes, std::uint64_t max_pixels,
                          const std::function<void(std::uint64_t bytes)>& reserve) {
  const char* name = file_name(bytes);
  if (std::string_view(name) == "image.png") {
    require_whole_png(bytes);
  }
  if (std::string_view(name) == "image.webp") {
    const std::uint64_t pixels = webp_pixels(bytes);
    require_few(pixels, max_pixels, fmt::format("{}", pixels));
    reserve(4 * pixels);
  }
  OIIO::Filesystem::IOMemReader reader(const_cast<std::uint8_t*>(bytes.data()), bytes.size());
  OIIO::ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1;
  // Without this PNG and JPEG look for a file of that name.
  OIIO::Filesystem::IOProxy* proxy = &reader;
  config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  const auto input = OIIO::ImageInput::open(name, &config, &reader);
  if (!input) {
    throw std::runtime_error(reason(OIIO::geterror()));
  }
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0) {
    throw std::runtime_error("has no pixels");
  }
  const auto count =
      static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height);
  require_few(count, max_pixels, fmt::format("{} x {}", spec.width, spec.height));
  reserve(4 * count);
  const auto channels = static_cast<std::size_t>(std::min(spec.nchannels, 4));
  std::vector<std::uint8_t> pixels(count * channels);
  if (!input->read_image(0, 0, 0, static_cast<int>(channels), OIIO::TypeDesc::UINT8,
                         pixels.data())) {
    throw std::runtime_error(reason(input->geterror()));
  }
  if (std::string_view(name) == "image.webp" && channels == 4) {
    make_straight(pixels);
  }
  return {.width = static_cast<std::uint32_t>(spec.width),
          .height = static_cast<std::uint32_t>(spec.height),
          .rgba = channels == 4 ? std::move(pixels) : expanded(pixels, count, channels)};
}

}  // namespace raycat
