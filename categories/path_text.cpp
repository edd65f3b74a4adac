#include "categories/path_text.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "categories/path_error.hpp"

namespace raycat::paths {
namespace {

constexpr std::string_view white = " \t\n\r\v\f";
constexpr std::string_view digits = "0123456789";

bool control(char c) {
  const auto code = static_cast<unsigned char>(c);
  return code < 0x20 || code == 0x7f;
}

bool continues_utf8(char c) { return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u; }

// Letters of light path expressions that have no meaning here, and why.
std::string_view why_not(char letter) {
  using Reason = std::pair<char, std::string_view>;
  constexpr std::array reasons{
      Reason{'D', "no surface scatters rays diffusely: rays reflect and refract specularly, S"},
      Reason{'G', "no surface scatters rays glossily: rays reflect and refract specularly, S"},
      Reason{'s',
             "a ray that goes straight through a surface is refracted, T, and its scattering is S"},
      Reason{'V', "there are no volumes"},
      Reason{'B', "the background is no hit"},
      Reason{'E', "the camera is C"},
      Reason{'C', "C, the camera, comes first and once"}};
  for (const auto& [known, reason] : reasons) {
    if (known == letter) {
      return reason;
    }
  }
  return {};
}

}  // namespace

void PathText::skip_space() {
  while (at_any(white)) {
    ++at_;
  }
}

bool PathText::take(char character) {
  if (at_end() || text_[at_] != character) {
    return false;
  }
  ++at_;
  skip_space();
  return true;
}

int PathText::number(int most) {
  std::size_t end = at_;
  int value = 0;
  while (end < text_.size() && digits.find(text_[end]) != digits.npos) {
    value = std::min(10 * value + (text_[end++] - '0'), most + 1);
  }
  const std::string expected = fmt::format("a number from 0 to {}", most);
  if (end == at_) {
    fail(expected);
  }
  if (value > most) {
    throw PathError(column(), fmt::format("expected {}, found {}", expected,
                                          text_.substr(at_, std::min<std::size_t>(end - at_, 20))));
  }
  at_ = end;
  skip_space();
  return value;
}

std::string PathText::quoted_name() {
  const std::size_t opened = column();
  const char mark = text_[at_++];
  std::string name;
  while (!at_end() && text_[at_] != mark) {
    if (text_[at_] == '\\') {
      ++at_;
      if (!at_any("'\"\\")) {
        fail("a quote or a backslash after the backslash");
      }
    }
    name += text_[at_++];
  }
  if (!take(mark)) {
    fail(fmt::format("{} to end the name of column {}", mark, opened));
  }
  return name;
}

void PathText::fail(std::string_view expected) const {
  if (at_end()) {
    throw PathError(column(), fmt::format("expected {}, found the end", expected));
  }
  if (control(text_[at_])) {
    const auto code = static_cast<unsigned char>(text_[at_]);
    throw PathError(column(), fmt::format("expected {}, found the byte {:#04x}", expected, code));
  }
  std::size_t end = at_ + 1;
  while (end < text_.size() && continues_utf8(text_[end])) {
    ++end;
  }
  const std::string_view why = why_not(text_[at_]);
  throw PathError(column(),
                  fmt::format("expected {}, found '{}'{}{}", expected, text_.substr(at_, end - at_),
                              why.empty() ? "" : ": ", why));
}

std::string quote(std::string_view name) {
  constexpr std::size_t longest = 60;
  std::size_t end = name.size();
  if (end > longest) {
    end = longest;
    while (end > 0 && continues_utf8(name[end])) {
      --end;
    }
  }
  std::string text = "'";
  for (const char c : name.substr(0, end)) {
    if (control(c)) {
      text += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    } else if (c == '\'' || c == '\\') {
      text += {'\\', c};
    } else {
      text += c;
    }
  }
  return text + (end < name.size() ? "...'" : "'");
}

}  // namespace raycat::paths
