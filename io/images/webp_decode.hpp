#pragma once

#include <cstdint>
#include <span>

#include "io/images/decoded_image.hpp"

namespace raycat {

/// Decodes a WebP, or the first image of an animated one. Throws `std::runtime_error` with the
/// reason if it is broken.
DecodedImage decode_webp(std::span<const std::uint8_t> bytes, const MakeRoom& make_room);

}  // namespace raycat
