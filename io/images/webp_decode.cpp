#include "io/images/webp_decode.hpp"

#include <cstddef>
#include <memory>
#include <stdexcept>

#include <webp/decode.h>
#include <webp/demux.h>

namespace raycat {
namespace {

// The file's chunks, which refer to its bytes.
using Chunks = std::unique_ptr<WebPDemuxer, decltype(&WebPDemuxDelete)>;

struct Frame {
  explicit Frame(const Chunks& chunks) : found(WebPDemuxGetFrame(chunks.get(), 1, &at) != 0) {}
  ~Frame() { WebPDemuxReleaseIterator(&at); }
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

  WebPIterator at{};
  bool found;
};

// Into its place on the canvas, of which it may be a part. libwebp checks the room that is left.
bool decode(const WebPIterator& frame, DecodedImage& image) {
  if (frame.x_offset < 0 || frame.y_offset < 0) {
    return false;
  }
  const std::size_t stride = std::size_t{4} * image.width;
  const std::size_t at = static_cast<std::size_t>(frame.y_offset) * stride +
                         std::size_t{4} * static_cast<std::size_t>(frame.x_offset);
  return at < image.rgba.size() &&
         WebPDecodeRGBAInto(frame.fragment.bytes, frame.fragment.size, image.rgba.data() + at,
                            image.rgba.size() - at, static_cast<int>(stride)) != nullptr;
}

}  // namespace

DecodedImage decode_webp(std::span<const std::uint8_t> bytes, const MakeRoom& make_room) {
  const WebPData data{.bytes = bytes.data(), .size = bytes.size()};
  const Chunks chunks(WebPDemux(&data), &WebPDemuxDelete);
  if (!chunks) {
    throw std::runtime_error("the WebP is broken or breaks off");
  }
  const auto info = [&](WebPFormatFeature what) { return WebPDemuxGetI(chunks.get(), what); };
  DecodedImage image = make_room(info(WEBP_FF_CANVAS_WIDTH), info(WEBP_FF_CANVAS_HEIGHT));
  const Frame first(chunks);
  if (!first.found || !decode(first.at, image)) {
    throw std::runtime_error("the WebP cannot be decoded");
  }
  if ((info(WEBP_FF_FORMAT_FLAGS) & ALPHA_FLAG) == 0) {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
      image.rgba[i] = 255;
    }
  }
  return image;
}

}  // namespace raycat
