#include "io/images/png_file.hpp"

#include <algorithm>
#include <cassert>
#include <csetjmp>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include <png.h>
#include <zlib.h>

#include "io/images/png_error.hpp"

namespace raycat {
namespace {

struct File : PngError {
  std::vector<std::byte> bytes;
};

void append(png_structp png, png_bytep data, png_size_t length) {
  File& file = *static_cast<File*>(png_get_io_ptr(png));
  bool full = false;
  try {
    const auto* bytes = reinterpret_cast<const std::byte*>(data);
    file.bytes.insert(file.bytes.end(), bytes, bytes + length);
  } catch (const std::exception&) {
    full = true;
  }
  if (full) {
    png_error(png, "out of memory");
  }
}

void flush(png_structp) {}

// Owns what libpng writes with. What it would warn of is an error here: nothing is to be left out
// of the file in silence.
class Writer {
 public:
  explicit Writer(File& file)
      : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, static_cast<PngError*>(&file),
                                     keep_png_error, keep_png_error)),
        info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {
    if (info_ == nullptr) {
      png_destroy_write_struct(&png_, nullptr);
      throw std::bad_alloc();
    }
    png_set_write_fn(png_, &file, append, flush);
  }
  ~Writer() { png_destroy_write_struct(&png_, &info_); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  png_structp png() const { return png_; }
  png_infop info() const { return info_; }

 private:
  png_structp png_;
  png_infop info_;
};

struct Kind {
  int colour_type;
  std::size_t bytes;  // a pixel
};

Kind kind(PngPixel pixel) {
  switch (pixel) {
    case PngPixel::rgb:
      return {PNG_COLOR_TYPE_RGB, 3};
    case PngPixel::rgba:
      return {PNG_COLOR_TYPE_RGB_ALPHA, 4};
    case PngPixel::index:
      break;
  }
  return {PNG_COLOR_TYPE_PALETTE, 1};
}

// Is false if libpng jumped back; the file says why.
bool write_all(const Writer& writer, const PngImage& image, std::span<const png_color> palette,
               std::span<const png_text> texts) {
  png_structp const png = writer.png();
  png_infop const info = writer.info();
  if (setjmp(png_jmpbuf(png)) != 0) {
    return false;
  }
  const auto [colour_type, pixel_bytes] = kind(image.pixel);
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  // Filters take more time than they save room.
  png_set_compression_strategy(png, Z_DEFAULT_STRATEGY);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_NO_FILTERS);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8, colour_type, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_ABSOLUTE);
  if (!palette.empty()) {
    png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
  }
  png_set_text(png, info, texts.data(), static_cast<int>(texts.size()));
  png_write_info(png, info);
  const std::size_t row_bytes = pixel_bytes * static_cast<std::size_t>(image.width);
  for (std::size_t row = 0; row < static_cast<std::size_t>(image.height); ++row) {
    png_write_row(png, image.bytes.data() + row * row_bytes);
  }
  png_write_end(png, info);
  return true;
}

// Refers to the strings. Those that are not ASCII are UTF-8, which has a kind of chunk of its own.
png_text text_chunk(const std::string& keyword, const std::string& text) {
  const bool ascii =
      std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  png_text chunk{};
  chunk.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
  chunk.key = const_cast<char*>(keyword.c_str());  // libpng copies both
  chunk.text = const_cast<char*>(text.c_str());
  chunk.text_length = text.size();
  return chunk;
}

}  // namespace

std::vector<std::byte> png_file(const PngImage& image, const Provenance& provenance) {
  assert((image.pixel == PngPixel::index) != image.palette.empty() && image.palette.size() <= 256);
  assert(image.bytes.size() == kind(image.pixel).bytes * static_cast<std::size_t>(image.width) *
                                   static_cast<std::size_t>(image.height));
  std::vector<png_color> palette;
  for (const auto& [red, green, blue] : image.palette) {
    palette.push_back({.red = red, .green = green, .blue = blue});
  }
  const auto texts = provenance_texts(provenance, "Description");
  std::vector<png_text> chunks;
  for (const auto& [keyword, text] : texts) {
    chunks.push_back(text_chunk(keyword, text));
  }
  File file;
  if (!write_all(Writer(file), image, palette, chunks)) {
    throw std::runtime_error(file.text.data());
  }
  return std::move(file.bytes);
}

}  // namespace raycat
