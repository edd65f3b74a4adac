#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace raycat::paths {

/// The text of a path expression, read from left to right. White space between tokens is passed
/// over: where this stands is always at a token or at the end.
class PathText {
 public:
  explicit PathText(std::string_view text) : text_(text) { skip_space(); }

  bool at_end() const noexcept { return at_ == text_.size(); }
  bool at_any(std::string_view characters) const noexcept {
    return !at_end() && characters.find(text_[at_]) != std::string_view::npos;
  }
  std::size_t column() const noexcept { return at_ + 1; }

  /// Passes over `character`, if it is next.
  bool take(char character);

  /// Reads a number from 0 to `most`.
  int number(int most);

  /// Reads a name in single or double quotes, of which one is next. A backslash takes the quote or
  /// backslash after it into the name.
  std::string quoted_name();

  /// Throws the `PathError` that `expected` was expected here; it says what is here instead and,
  /// for letters that light path expressions have elsewhere, why they are not read.
  [[noreturn]] void fail(std::string_view expected) const;

 private:
  void skip_space();

  std::string_view text_;
  std::size_t at_ = 0;
};

/// `name` in single quotes, as an expression would have it, for messages: cut if it is long, and
/// without control characters.
std::string quote(std::string_view name);

}  // namespace raycat::paths
