#include "io/meshes/mesh_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

namespace raycat {
namespace {

// Is a well-formed number that no double comes near too small rather than too large? Zero digits
// before and after the point can outweigh the exponent.
bool is_below_double(std::string_view word) {
  const std::string_view digits = word.substr(0, word.find_first_of("eE"));
  std::string_view power = word.substr(std::min(digits.size() + 1, word.size()));
  power.remove_prefix(power.starts_with('+') ? 1 : 0);
  std::int32_t exponent = 0;
  const auto [end, error] = std::from_chars(power.data(), power.data() + power.size(), exponent);
  if (error == std::errc::result_out_of_range) {
    return power.starts_with('-');
  }
  const auto point = static_cast<std::int64_t>(std::min(digits.find('.'), digits.size()));
  const auto first = static_cast<std::int64_t>(digits.find_first_of("123456789"));
  return exponent + point - first < 0;
}

}  // namespace

void refuse_line(std::size_t line, std::string_view what) {
  throw std::invalid_argument(fmt::format("line {}: {}", line, what));
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

std::string_view without_comment(std::string_view line, std::string_view comment) {
  return line.substr(0, line.find_first_of(comment));
}

void split(std::string_view line, MeshWords& words) {
  constexpr std::string_view blanks = " \t\r\v\f";
  words.clear();
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(blanks, end);
  }
}

std::optional<double> read_number(std::string_view word) {
  word.remove_prefix(word.starts_with('+') ? 1 : 0);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size()) {
    return std::nullopt;
  }
  // Numbers too small for a double are written by some tools and mean 0.
  if (error == std::errc::result_out_of_range) {
    return is_below_double(word) ? std::optional(0.0) : std::nullopt;
  }
  return error == std::errc() ? std::optional(value) : std::nullopt;
}

glm::dvec3 read_point(const MeshWords& words, std::size_t first, std::size_t line) {
  glm::dvec3 point;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t i = first + static_cast<std::size_t>(axis);
    const std::optional<double> number = i < words.size() ? read_number(words[i]) : std::nullopt;
    if (!number || !std::isfinite(static_cast<float>(*number))) {
      refuse_line(line, "a vertex needs three finite numbers");
    }
    point[axis] = *number;
  }
  return point;
}

std::string_view MeshWordReader::take() {
  while (at_ == words_.size()) {
    if (rest_.empty()) {
      throw std::invalid_argument(std::string(ended_));
    }
    split(without_comment(take_line(rest_), comment_), words_);
    at_ = 0;
    ++line_;
  }
  return words_[at_++];
}

std::size_t MeshWordReader::lines() const {
  std::size_t count = left_of_line() > 0 ? 1 : 0;
  MeshWords words;
  for (std::string_view rest = rest_; !rest.empty();) {
    split(without_comment(take_line(rest), comment_), words);
    count += words.empty() ? 0U : 1U;
  }
  return count;
}

}  // namespace raycat
