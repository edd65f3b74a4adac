#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include <glm/vec3.hpp>

namespace raycat {

/// The words of a line of a mesh file.
using MeshWords = std::vector<std::string_view>;

/// Throws `std::invalid_argument` that names the line.
[[noreturn]] void refuse_line(std::size_t line, std::string_view what);

/// Takes the next line off `text`.
std::string_view take_line(std::string_view& text);

/// Sets `words` to those of `line`, and keeps its capacity for the next.
void split(std::string_view line, MeshWords& words);

/// A number in decimal notation; one too small for a double is 0. None if it is something else or
/// too large.
std::optional<double> read_number(std::string_view word);

/// Three numbers of `words` from `first` on. Throws `std::invalid_argument` unless they are there
/// and finite as a `float`, which is what rays are first tested in.
glm::dvec3 read_point(const MeshWords& words, std::size_t first, std::size_t line);

template <typename Integer>
bool read_integer(std::string_view word, Integer& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace raycat
