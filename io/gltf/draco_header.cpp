#include "io/gltf/draco_header.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace raycat {
namespace {

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : left_(bytes) {}

  std::span<const std::uint8_t> bytes(std::uint64_t count) {
    if (count > left_.size()) {
      throw std::runtime_error("the Draco header breaks off");
    }
    const auto taken = left_.first(count);
    left_ = left_.subspan(count);
    return taken;
  }

  std::uint8_t byte() { return bytes(1)[0]; }

  // Seven bits a byte, the lowest first.
  std::uint64_t varint() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 63; shift += 7) {
      const std::uint8_t next = byte();
      value |= std::uint64_t{next & 0x7fu} << shift;
      if (next < 0x80) {
        return value;
      }
    }
    throw std::runtime_error("the Draco header holds a number that is too large");
  }

 private:
  std::span<const std::uint8_t> left_;
};

// Named values, and more of them nested. Draco's own reader is as deep as they are.
void skip_metadata(Reader& reader) {
  constexpr std::size_t max_depth = 64;
  const std::uint64_t attributes = reader.varint();
  for (std::uint64_t i = 0; i <= attributes; ++i) {  // each attribute's, and the mesh's
    if (i < attributes) {
      reader.varint();
    }
    std::vector<std::uint64_t> pending{1};  // at each depth
    while (!pending.empty()) {
      if (pending.back()-- == 0) {
        pending.pop_back();
        continue;
      }
      if (pending.size() > 1) {
        reader.bytes(reader.byte());  // its name
      }
      for (std::uint64_t entries = reader.varint(); entries > 0; --entries) {
        reader.bytes(reader.byte());
        reader.bytes(reader.varint());
      }
      pending.push_back(reader.varint());
      if (pending.size() > max_depth) {
        throw std::runtime_error(
            fmt::format("Draco metadata is nested more than {} deep", max_depth));
      }
    }
  }
}

}  // namespace

DracoHeader draco_header(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view magic = "DRACO";
  constexpr std::uint8_t mesh = 1;
  constexpr std::uint8_t edgebreaker = 1;
  constexpr std::uint16_t metadata_flag = 0x8000;
  Reader reader(bytes);
  const auto begins = reader.bytes(magic.size());
  if (!std::equal(begins.begin(), begins.end(), magic.begin())) {
    throw std::runtime_error("is not Draco");
  }
  const int major = reader.byte();
  const int minor = reader.byte();
  if (major != 2 || minor != 2) {
    throw std::runtime_error(
        fmt::format("Draco bitstream {}.{} is not supported, only 2.2", major, minor));
  }
  if (reader.byte() != mesh) {
    throw std::runtime_error("the Draco data is no mesh");
  }
  const std::uint8_t method = reader.byte();
  const auto low = reader.byte();
  const auto flags = static_cast<std::uint16_t>(low | reader.byte() << 8);
  if ((flags & metadata_flag) != 0) {
    skip_metadata(reader);
  }
  DracoHeader header;
  if (method == edgebreaker) {
    reader.byte();  // how the connectivity is traversed
    header.points = reader.varint();
    header.faces = reader.varint();
  } else {
    header.faces = reader.varint();
    header.points = reader.varint();
  }
  return header;
}

}  // namespace raycat
