#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "io/images/decoded_image.hpp"

namespace raycat {

/// Decodes a PNG, JPEG or WebP, told by its content. Throws `std::runtime_error` with the reason if
/// it is neither, broken, or has more than `max_pixels`, which is checked before it is decoded.
/// Tells `reserve` how many bytes it will hold, before it makes room for them.
DecodedImage decode_image(
    std::span<const std::uint8_t> bytes, std::uint64_t max_pixels,
    const std::function<void(std::uint64_t bytes)>& reserve = [](std::uint64_t) {});

}  // namespace raycat
