#include "io/openscad/height_file.hpp"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "io/files/excerpt.hpp"
#include "io/files/input_file.hpp"
#include "io/images/decode.hpp"
#include "modelling/height_map.hpp"

namespace raycat {

namespace {

constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 28;
constexpr std::uint64_t most_pixels = std::uint64_t{1} << 24;

std::vector<double> row_of(std::string_view line, std::size_t number) {
  std::vector<double> row;
  while (!line.empty()) {
    if (line.front() == ' ' || line.front() == '\t' || line.front() == '\r') {
      line.remove_prefix(1);
      continue;
    }
    double value = 0.0;
    const auto [rest, error] = std::from_chars(line.data(), line.data() + line.size(), value);
    if (error != std::errc() || !std::isfinite(value)) {
      throw std::runtime_error(fmt::format("line {} has '{}' where a number is expected", number,
                                           excerpt(line.substr(0, line.find_first_of(" \t\r")))));
    }
    row.push_back(value);
    line.remove_prefix(static_cast<std::size_t>(rest - line.data()));
  }
  return row;
}

HeightRows rows_of_text(std::string_view text) {
  HeightRows rows;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    std::vector<double> row = row_of(line.substr(0, line.find('#')), number);
    if (!row.empty()) {
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

// An image's last row is at y = 0.
HeightRows rows_of_image(const Bytes& bytes, bool invert) {
  const DecodedImage image = decode_image(bytes, most_pixels);
  HeightRows rows(image.height, std::vector<double>(image.width));
  const std::uint8_t* pixel = image.rgba.data();
  for (std::size_t y = image.height; y-- > 0;) {
    for (double& height : rows[y]) {
      height = pixel_height({pixel[0], pixel[1], pixel[2]}, invert);
      pixel += 4;
    }
  }
  return rows;
}

}  // namespace

HeightRows read_heights(const std::filesystem::path& file, bool invert) {
  const Bytes bytes = read_bytes(file, most_bytes);
  if (lower_extension(file) == ".png") {
    return rows_of_image(bytes, invert);
  }
  return rows_of_text({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace raycat
