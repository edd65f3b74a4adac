#include "io/files/load_error.hpp"

#include <algorithm>

namespace raycat {
namespace {

// The message is one line whatever the file is called or holds.
std::string one_line(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }, ' ');
  return text;
}

std::string message(const std::filesystem::path& file, const std::string& place,
                    const std::string& what) {
  return one_line(file.string() + ": " + (place.empty() ? "" : place + ": ") + what);
}

}  // namespace

LoadError::LoadError(const std::filesystem::path& file, const std::string& place,
                     const std::string& what)
    : std::runtime_error(message(file, place, what)) {}

}  // namespace raycat
