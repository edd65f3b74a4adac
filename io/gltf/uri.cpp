#include "io/gltf/uri.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>

#include <fmt/format.h>

#include "io/files/contained_path.hpp"
#include "io/files/excerpt.hpp"

namespace raycat {
namespace {

int hex_digit(char c) noexcept {
  if (c >= '0' && c <= '9') {
    return c - '0';
  }
  const char lower = static_cast<char>(c | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

std::string percent_decoded(std::string_view text) {
  std::string decoded;
  decoded.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    const int high = i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
    const int low = i + 2 < text.size() ? hex_digit(text[i + 2]) : -1;
    if (high < 0 || low < 0) {
      throw std::runtime_error("a % in the URI is not followed by two hexadecimal digits");
    }
    decoded += static_cast<char>(16 * high + low);
    i += 2;
  }
  return decoded;
}

bool has_scheme(std::string_view uri) {
  const auto colon = uri.find(':');
  return colon != std::string_view::npos && uri.find('/') > colon;
}

std::array<std::int8_t, 256> base64_values() {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::int8_t, 256> values{};
  values.fill(-1);
  for (std::size_t i = 0; i < digits.size(); ++i) {
    values[static_cast<unsigned char>(digits[i])] = static_cast<std::int8_t>(i);
  }
  return values;
}

Bytes decode_base64(std::string_view text) {
  static const auto values = base64_values();
  while (!text.empty() && text.back() == '=') {
    text.remove_suffix(1);
  }
  Bytes bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    const int value = values[static_cast<unsigned char>(c)];
    if (value < 0) {
      throw std::runtime_error("the data URI is not base64");
    }
    bits = (bits << 6) | static_cast<std::uint32_t>(value);
    held += 6;
    if (held >= 8) {
      held -= 8;
      bytes.push_back(static_cast<std::uint8_t>(bits >> held));
    }
  }
  return bytes;
}

}  // namespace

std::filesystem::path resolve_uri(const std::filesystem::path& folder, std::string_view uri) {
  if (has_scheme(uri)) {
    throw std::runtime_error(
        fmt::format("URI '{}' has a scheme; only relative URIs are read", excerpt(uri)));
  }
  return contained_path(folder, percent_decoded(uri), "URI");
}

bool is_data_uri(std::string_view uri) noexcept {
  constexpr std::string_view scheme = "data:";
  return uri.size() >= scheme.size() &&
         std::equal(scheme.begin(), scheme.end(), uri.begin(), [](char a, char b) {
           return a == std::tolower(static_cast<unsigned char>(b));
         });
}

Bytes decode_data_uri(std::string_view uri) {
  const auto comma = uri.find(',');
  if (comma == std::string_view::npos) {
    throw std::runtime_error("the data URI has no comma");
  }
  const auto content = uri.substr(comma + 1);
  if (uri.substr(0, comma).ends_with(";base64")) {
    return content.find('%') == std::string_view::npos ? decode_base64(content)
                                                       : decode_base64(percent_decoded(content));
  }
  const std::string decoded = percent_decoded(content);
  return {decoded.begin(), decoded.end()};
}

Bytes read_uri(const std::filesystem::path& folder, std::string_view uri,
               const std::function<void(std::uint64_t bytes)>& reserve) {
  if (is_data_uri(uri)) {
    reserve(uri.size());
    return decode_data_uri(uri);
  }
  return read_bytes(resolve_uri(folder, uri), max_gltf_bytes, reserve);
}

}  // namespace raycat
