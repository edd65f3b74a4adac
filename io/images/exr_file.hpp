#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "io/images/provenance.hpp"

namespace raycat {

/// A channel of an image where it lies in memory: values of four bytes, `float` or
/// `std::uint32_t`, rows from the top.
struct ExrChannel {
  std::string name;
  bool whole = false;  ///< numbers are `std::uint32_t`
  const void* first = nullptr;
  std::size_t stride = 4;  ///< bytes from one value to the next
};

/// The bytes of an OpenEXR file of these channels, without loss, always the same of one image.
/// Throws `std::runtime_error` with OpenEXR's reason alone.
std::vector<std::byte> exr_file(int width, int height, std::span<const ExrChannel> channels,
                                const Provenance& provenance);

}  // namespace raycat
