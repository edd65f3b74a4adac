#pragma once

#include <cstdint>
#include <span>

namespace raycat {

/// How large a Draco mesh says it is.
struct DracoHeader {
  std::uint64_t faces = 0;
  std::uint64_t points = 0;
};

/// Reads the beginning of a Draco bitstream of version 2.2, so that a small stream which claims to
/// be large is known before the decoder makes room for it. Throws `std::runtime_error` with the
/// reason if it is not such a mesh.
DracoHeader draco_header(std::span<const std::uint8_t> bytes);

}  // namespace raycat
