#include "io/images/jpeg_decode.hpp"

#include <array>
#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>
// Needs the two above.
#include <jpeglib.h>
// Needs the one above.
#include <jerror.h>

namespace raycat {
namespace {

// A few bytes can say that all of an image is refined once more. Files have about ten such scans.
constexpr int most_scans = 100;

// Where to jump when libjpeg fails, and why it did. No destructor lives on the way.
struct Failure {
  jpeg_error_mgr handlers{};
  std::jmp_buf caller{};
  std::array<char, JMSG_LENGTH_MAX> text{};
};

Failure& failure(j_common_ptr jpeg) { return *static_cast<Failure*>(jpeg->client_data); }

[[noreturn]] void fail(j_common_ptr jpeg) {
  jpeg->err->format_message(jpeg, failure(jpeg).text.data());
  std::longjmp(failure(jpeg).caller, 1);
}

// Libjpeg warns (below 0) where it goes on with pixels that are not in the file.
void note(j_common_ptr jpeg, int level) {
  switch (jpeg->err->msg_code) {
    case JWRN_ARITH_BAD_CODE:
    case JWRN_HIT_MARKER:
    case JWRN_HUFF_BAD_CODE:
    case JWRN_MUST_RESYNC:
      if (level < 0) {
        fail(jpeg);
      }
      break;
    default:
      break;
  }
}

void count_scans(j_common_ptr jpeg) {
  if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number > most_scans) {
    std::snprintf(failure(jpeg).text.data(), failure(jpeg).text.size(), "it has more than %d scans",
                  most_scans);
    std::longjmp(failure(jpeg).caller, 1);
  }
}

// Owns what libjpeg reads with.
class Reader {
 public:
  Reader() {
    jpeg_.err = jpeg_std_error(&failure_.handlers);
    jpeg_.err->error_exit = fail;
    jpeg_.err->emit_message = note;
    jpeg_.err->output_message = [](j_common_ptr) {};
    jpeg_.client_data = &failure_;
    progress_.progress_monitor = count_scans;
  }
  ~Reader() { jpeg_destroy_decompress(&jpeg_); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  jpeg_decompress_struct& jpeg() { return jpeg_; }
  Failure& failure() { return failure_; }
  jpeg_progress_mgr& progress() { return progress_; }

 private:
  jpeg_decompress_struct jpeg_{};
  Failure failure_;
  jpeg_progress_mgr progress_{};
};

// Are false if libjpeg jumped back; the failure says why.
bool read_header(Reader& reader, std::span<const std::uint8_t> bytes) {
  if (setjmp(reader.failure().caller) != 0) {
    return false;
  }
  jpeg_create_decompress(&reader.jpeg());
  reader.jpeg().progress = &reader.progress();
  jpeg_mem_src(&reader.jpeg(), bytes.data(), bytes.size());
  jpeg_read_header(&reader.jpeg(), TRUE);
  return true;
}

bool holds_inks(const jpeg_decompress_struct& jpeg) {
  return jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK;
}

bool read_pixels(Reader& reader, std::span<std::uint8_t> rgba) {
  if (setjmp(reader.failure().caller) != 0) {
    return false;
  }
  jpeg_decompress_struct& jpeg = reader.jpeg();
  jpeg.out_color_space = holds_inks(jpeg) ? JCS_CMYK : JCS_EXT_RGBA;
  jpeg_start_decompress(&jpeg);
  const std::size_t row_bytes = std::size_t{4} * jpeg.output_width;
  while (jpeg.output_scanline < jpeg.output_height) {
    JSAMPROW row = rgba.data() + jpeg.output_scanline * row_bytes;
    jpeg_read_scanlines(&jpeg, &row, 1);
  }
  return true;
}

// Inks are inverted: how much light each lets through.
void make_light(std::span<std::uint8_t> cmyk) {
  constexpr unsigned full = 255;
  for (std::size_t i = 0; i + 3 < cmyk.size(); i += 4) {
    const unsigned black = cmyk[i + 3];
    for (std::size_t c = i; c < i + 3; ++c) {
      cmyk[c] = static_cast<std::uint8_t>((cmyk[c] * black + full / 2) / full);
    }
    cmyk[i + 3] = full;
  }
}

void require(bool read, Reader& reader) {
  if (!read) {
    throw std::runtime_error(
        fmt::format("the JPEG cannot be decoded: {}", reader.failure().text.data()));
  }
}

}  // namespace

DecodedImage decode_jpeg(std::span<const std::uint8_t> bytes, const MakeRoom& make_room) {
  Reader reader;
  require(read_header(reader, bytes), reader);
  DecodedImage image = make_room(reader.jpeg().image_width, reader.jpeg().image_height);
  require(read_pixels(reader, image.rgba), reader);
  if (holds_inks(reader.jpeg())) {
    make_light(image.rgba);
  }
  return image;
}

}  // namespace raycat
