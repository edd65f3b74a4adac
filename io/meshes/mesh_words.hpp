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

/// What a line holds before a letter of `comment`.
std::string_view without_comment(std::string_view line, std::string_view comment);

/// Sets `words` to those of `line`, and keeps its capacity for the next.
void split(std::string_view line, MeshWords& words);

/// A number in decimal notation; one too small for a double is 0. None if it is something else or
/// too large.
std::optional<double> read_number(std::string_view word);

/// Three numbers of `words` from `first` on. Throws `std::invalid_argument` unless they are there
/// and finite as a `float`, which is what rays are first tested in.
glm::dvec3 read_point(const MeshWords& words, std::size_t first, std::size_t line);

/// The words of a text file one after the other, whatever lines they are on.
class MeshWordReader {
 public:
  /// The first line of `text` is the one that is numbered `line`. From a letter of `comment` on, a
  /// line is passed over. `ended` is what is said of a file that ends before a word that is asked
  /// for.
  MeshWordReader(std::string_view text, std::size_t line, std::string_view comment,
                 std::string_view ended)
      : rest_(text), line_(line - 1), comment_(comment), ended_(ended) {}

  /// The next. Throws `std::invalid_argument` at the end.
  std::string_view take();

  /// Of the word that was taken last.
  std::size_t line() const noexcept { return line_; }

  /// How many words does its line hold still?
  std::size_t left_of_line() const noexcept { return words_.size() - at_; }

  void pass_line() noexcept { at_ = words_.size(); }

  /// How many lines hold words still?
  std::size_t lines() const;

  /// At least as many as there are words.
  std::size_t left() const noexcept { return rest_.size() + left_of_line(); }

 private:
  std::string_view rest_;
  MeshWords words_;
  std::size_t at_ = 0;
  std::size_t line_;
  std::string_view comment_;
  std::string_view ended_;
};

template <typename Integer>
bool read_integer(std::string_view word, Integer& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace raycat
