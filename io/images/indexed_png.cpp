#include "io/images/indexed_png.hpp"

#include <algorithm>
#include <cassert>
#include <csetjmp>
#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>
#include <png.h>

#include "io/files/input_file.hpp"
#include "io/files/output_file.hpp"

namespace raycat {
namespace {

namespace fs = std::filesystem;

// libpng reports errors by jumping back to where it was called from, past destructors. So nothing
// that has one lives on the way: callbacks keep what they must in here, and the functions that
// call libpng are handed all they need.
struct File {
  std::vector<std::byte> bytes;
  std::array<char, 200> error{};
};

[[noreturn]] void fail(png_structp png, png_const_charp message) {
  File& file = *static_cast<File*>(png_get_error_ptr(png));
  std::snprintf(file.error.data(), file.error.size(), "%s", message);
  png_longjmp(png, 1);
}

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
      : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &file, fail, fail)),
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

// Is false if libpng jumped back; the file says why.
bool write_all(const Writer& writer, const IndexedImage& image, std::span<const png_color> palette,
               std::span<const png_text> texts) {
  png_structp const png = writer.png();
  png_infop const info = writer.info();
  if (setjmp(png_jmpbuf(png)) != 0) {
    return false;
  }
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_PALETTE,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_RELATIVE);
  png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
  png_set_text(png, info, texts.data(), static_cast<int>(texts.size()));
  png_write_info(png, info);
  const auto columns = static_cast<std::size_t>(image.width);
  for (std::size_t row = 0; row < static_cast<std::size_t>(image.height); ++row) {
    png_write_row(png, image.pixels.data() + row * columns);
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

// Under the keywords that write_image gives them.
std::vector<std::pair<std::string, std::string>> keyed(const Provenance& provenance) {
  std::vector<std::pair<std::string, std::string>> texts{
      {"Software", provenance.command}, {"Description", "scene " + provenance.scene}};
  if (!provenance.legend.empty()) {
    texts.emplace_back("Legend", provenance.legend);
  }
  return texts;
}

}  // namespace

void require_indexed_path(const fs::path& path) {
  std::error_code ignored;
  if (lower_extension(path) != ".png" && !fs::is_character_file(path, ignored)) {
    throw std::invalid_argument(fmt::format("{}: indexed images end in .png", path.string()));
  }
}

void write_indexed_png(const fs::path& path, const IndexedImage& image,
                       std::span<const std::array<std::uint8_t, 3>> palette,
                       const Provenance& provenance) {
  require_indexed_path(path);
  assert(!palette.empty() && palette.size() <= 256);
  assert(image.pixels.size() ==
         static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  assert(std::ranges::all_of(image.pixels, [&](std::uint8_t i) { return i < palette.size(); }));

  std::vector<png_color> colours;
  for (const auto& [red, green, blue] : palette) {
    colours.push_back({.red = red, .green = green, .blue = blue});
  }
  const std::vector<std::pair<std::string, std::string>> texts = keyed(provenance);
  std::vector<png_text> chunks;
  for (const auto& [keyword, text] : texts) {
    chunks.push_back(text_chunk(keyword, text));
  }

  File file;
  if (!write_all(Writer(file), image, colours, chunks)) {
    throw std::runtime_error(fmt::format("{}: {}", path.string(), file.error.data()));
  }
  write_file(path, file.bytes);
}

}  // namespace raycat
