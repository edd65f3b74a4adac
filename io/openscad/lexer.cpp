#include "io/openscad/lexer.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

#include <fmt/format.h>

#include "io/files/load_error.hpp"

namespace raycat::openscad {

namespace {

// <cctype> depends on the locale and is undefined for negative characters.
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_';
}
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

}  // namespace

Lexer::Lexer(const std::filesystem::path& file, std::string_view text) : file_(file), text_(text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text_.starts_with(byte_order_mark)) {
    at_ = byte_order_mark.size();
  }
}

void Lexer::skip_blanks() {
  while (at_ < text_.size()) {
    const std::string_view rest = text_.substr(at_);
    if (is_blank(rest[0])) {
      line_ += rest[0] == '\n' ? 1U : 0U;
      ++at_;
    } else if (rest.starts_with("//")) {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (rest.starts_with("/*")) {
      const std::size_t end = text_.find("*/", at_ + 2);
      if (end == std::string_view::npos) {
        throw LoadError(file_, line_place(line_), "comment without */");
      }
      const std::string_view comment = text_.substr(at_, end - at_);
      line_ += static_cast<std::uint32_t>(std::ranges::count(comment, '\n'));
      at_ = end + 2;
    } else {
      return;
    }
  }
}

Token Lexer::next() {
  skip_blanks();
  Token token{.line = line_};
  if (at_ == text_.size()) {
    return token;
  }
  const char first = text_[at_];
  const char second = at_ + 1 < text_.size() ? text_[at_ + 1] : '\0';
  if (is_digit(first) || ((first == '-' || first == '+' || first == '.') &&
                          (is_digit(second) || (first != '.' && second == '.')))) {
    return number();
  }
  if (first == '"') {
    return string();
  }
  std::size_t length = 1;
  if (is_word(first) || (first == '$' && is_word(second))) {
    while (at_ + length < text_.size() && is_word(text_[at_ + length])) {
      ++length;
    }
    token.kind = Token::Kind::word;
  } else if (std::string_view("%#!*()[]{},;=-").find(first) != std::string_view::npos) {
    token.kind = Token::Kind::symbol;
  } else {
    const bool printable = first > ' ' && first <= '~';
    throw LoadError(file_, line_place(line_),
                    printable
                        ? fmt::format("unexpected character '{}'", first)
                        : fmt::format("unexpected byte 0x{:02X}",
                                      static_cast<unsigned>(static_cast<unsigned char>(first))));
  }
  token.text = text_.substr(at_, length);
  at_ += length;
  return token;
}

Token Lexer::number() {
  Token token{.kind = Token::Kind::number, .line = line_};
  const std::size_t sign = text_[at_] == '+' ? 1 : 0;
  const char* const begin = text_.data() + at_;
  const auto [end, error] =
      std::from_chars(begin + sign, text_.data() + text_.size(), token.number);
  token.text = std::string_view(begin, static_cast<std::size_t>(end - begin));
  if (error == std::errc::result_out_of_range) {
    throw LoadError(file_, line_place(line_),
                    fmt::format("the number {:.40} is out of range", token.text));
  }
  if (error != std::errc() || (end != text_.data() + text_.size() && is_word(*end))) {
    throw LoadError(file_, line_place(line_), "malformed number");
  }
  at_ += token.text.size();
  return token;
}

Token Lexer::string() {
  Token token{.kind = Token::Kind::string, .line = line_};
  const std::size_t begin = ++at_;
  while (at_ < text_.size() && text_[at_] != '"') {
    line_ += text_[at_] == '\n' ? 1U : 0U;
    at_ += text_[at_] == '\\' ? 2U : 1U;
  }
  if (at_ >= text_.size()) {
    throw LoadError(file_, line_place(token.line), "string without closing quote");
  }
  token.text = text_.substr(begin, at_ - begin);
  ++at_;
  return token;
}

std::string quoted(const Token& token) {
  switch (token.kind) {
    case Token::Kind::end:
      return "the end of the file";
    case Token::Kind::string:
      return "a string";
    default:
      return fmt::format("'{:.40}'", token.text);
  }
}

std::string line_place(std::uint32_t line) { return fmt::format("line {}", line); }

}  // namespace raycat::openscad
