#include "io/files/excerpt.hpp"

#include <algorithm>

namespace raycat {

std::string excerpt(std::string_view text) {
  constexpr std::size_t most = 100;
  bool cut = text.size() > most;
  std::size_t end = std::min(text.size(), most);
  // Never between the bytes of one UTF-8 character.
  while (cut && end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0u) == 0x80u) {
    --end;
  }
  std::string line(text.substr(0, end));
  std::ranges::replace_if(
      line, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
  return cut ? line + "..." : line;
}

}  // namespace raycat
