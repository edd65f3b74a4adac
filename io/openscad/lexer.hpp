#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace raycat::openscad {

struct Token {
  enum class Kind { word, number, string, symbol, end };

  Kind kind = Kind::end;
  std::string_view text{};  ///< as in the file; without the quotes of a string, escapes unresolved
  std::uint32_t line = 1;
  double number = 0.0;
};

/// Splits the text of a .csg file into words (which may begin with $), numbers, strings and
/// symbols of one character; blanks and comments are left out.
class Lexer {
 public:
  Lexer(const std::filesystem::path& file, std::string_view text);

  /// The next token; the end, once reached, again and again. Throws `LoadError` for a comment or
  /// string without end, a number out of range and a character that no token begins with.
  Token next();

 private:
  void skip_blanks();
  Token number();
  Token string();

  const std::filesystem::path& file_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::uint32_t line_ = 1;
};

/// The token as an error message shows it: `'}'`, `the end of the file`.
std::string quoted(const Token& token);

/// Where a `LoadError` is: `line 12`.
std::string line_place(std::uint32_t line);

}  // namespace raycat::openscad
