#pragma once

#include <cstdint>
#include <span>

#include "io/images/decoded_image.hpp"

namespace raycat {

/// Decodes a JPEG of grey, colours or inks (CMYK as Adobe has it, inverted), as if it were sRGB.
/// Throws `std::runtime_error` with the reason if it is broken or lacks pixels.
DecodedImage decode_jpeg(std::span<const std::uint8_t> bytes, const MakeRoom& make_room);

}  // namespace raycat
