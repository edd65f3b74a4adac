#pragma once

#include <cstdint>
#include <span>

#include "io/images/decoded_image.hpp"

namespace raycat {

/// Decodes a PNG of any kind, as if it were sRGB: profiles and gamma are passed over, and 16 bits
/// are rounded to 8. Throws `std::runtime_error` with the reason if it is broken.
DecodedImage decode_png(std::span<const std::uint8_t> bytes, const MakeRoom& make_room);

}  // namespace raycat
