#include "io/images/png_decode.hpp"

#include <algorithm>
#include <cassert>
#include <csetjmp>
#include <cstddef>
#include <new>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <png.h>

#include "io/images/png_error.hpp"

namespace raycat {
namespace {

// Throws unless every chunk is there to its end, so that this has one reason whichever chunk it is.
void require_whole(std::span<const std::uint8_t> bytes) {
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

struct Source : PngError {
  std::span<const std::uint8_t> left;
};

void take(png_structp png, png_bytep data, png_size_t length) {
  Source& source = *static_cast<Source*>(png_get_io_ptr(png));
  if (length > source.left.size()) {
    png_error(png, "it breaks off");
  }
  std::copy_n(source.left.data(), length, data);
  source.left = source.left.subspan(length);
}

// Owns what libpng reads with. What it warns of costs no pixels.
class Reader {
 public:
  explicit Reader(Source& source)
      : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, static_cast<PngError*>(&source),
                                    keep_png_error, [](png_structp, png_const_charp) {})),
        info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(png_, &source, take);
  }
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  png_structp png() const { return png_; }
  png_infop info() const { return info_; }

 private:
  png_structp png_;
  png_infop info_;
};

// Are false if libpng jumped back; the source says why.
bool read_header(const Reader& reader) {
  if (setjmp(png_jmpbuf(reader.png())) != 0) {
    return false;
  }
  // All chunks but those that pixels are made of, so that none takes room or time.
  png_set_keep_unknown_chunks(reader.png(), PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  png_read_info(reader.png(), reader.info());
  return true;
}

bool read_pixels(const Reader& reader, std::span<std::uint8_t> rgba) {
  png_structp const png = reader.png();
  if (setjmp(png_jmpbuf(png)) != 0) {
    return false;
  }
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 255, PNG_FILLER_AFTER);
  const int passes = png_set_interlace_handling(png);
  png_read_update_info(png, reader.info());
  const std::size_t row_bytes = png_get_rowbytes(png, reader.info());
  const std::size_t rows = png_get_image_height(png, reader.info());
  if (row_bytes * rows != rgba.size()) {
    png_error(png, "its pixels are of no known kind");
  }
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t row = 0; row < rows; ++row) {
      png_read_row(png, rgba.data() + row * row_bytes, nullptr);
    }
  }
  return true;
}

void require(bool read, const Source& source) {
  if (!read) {
    throw std::runtime_error(fmt::format("the PNG cannot be decoded: {}", source.text.data()));
  }
}

}  // namespace

DecodedImage decode_png(std::span<const std::uint8_t> bytes, const MakeRoom& make_room) {
  require_whole(bytes);
  Source source;
  source.left = bytes;
  const Reader reader(source);
  require(read_header(reader), source);
  DecodedImage image = make_room(png_get_image_width(reader.png(), reader.info()),
                                 png_get_image_height(reader.png(), reader.info()));
  require(read_pixels(reader, image.rgba), source);
  return image;
}

}  // namespace raycat
