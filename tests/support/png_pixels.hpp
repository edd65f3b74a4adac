#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include <png.h>

namespace raycat {

/// What a viewer sees of a PNG file.
struct PngPixels {
  int width = 0;
  int height = 0;
  bool alpha = false;               ///< of the file
  std::vector<std::uint8_t> bytes;  ///< sRGB, with straight alpha if the file has it
};

inline PngPixels png_pixels(const std::filesystem::path& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) {
    throw std::runtime_error(image.message);
  }
  PngPixels pixels{.width = static_cast<int>(image.width),
                   .height = static_cast<int>(image.height),
                   .alpha = (image.format & PNG_FORMAT_FLAG_ALPHA) != 0};
  image.format = pixels.alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  pixels.bytes.resize(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, pixels.bytes.data(), 0, nullptr) == 0) {
    throw std::runtime_error(image.message);
  }
  return pixels;
}

}  // namespace raycat
