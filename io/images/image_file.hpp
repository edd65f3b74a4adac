#pragma once

#include <filesystem>

#include "io/images/provenance.hpp"
#include "tracer/image.hpp"

namespace raycat {

/// Throws `std::invalid_argument` unless `path` names a kind of image that can be written: it
/// ends in .png, .exr or .ppm, or is a device, which is sent PNG.
void require_image_path(const std::filesystem::path& path);

/// Can an image there have alpha?
bool holds_alpha(const std::filesystem::path& path);

/// Writes `image` as sRGB, 8 bits a channel and clamped to what these can show (PNG, PPM), or as
/// linear float (EXR). Its alpha is associated in EXR and straight in PNG, as these formats have
/// it, and is left out of PPM, which has none. The file is there whole or not at all. Throws as
/// `require_image_path` does, and `std::runtime_error` if it cannot be written.
void write_image(const std::filesystem::path& path, const Image& image,
                 const Provenance& provenance = {});

}  // namespace raycat
