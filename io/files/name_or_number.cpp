#include "io/files/name_or_number.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace raycat {

std::optional<std::size_t> name_or_number(std::span<const std::string> names,
                                          const std::string& wanted) {
  const auto named = std::ranges::find(names, wanted);
  if (named != names.end()) {
    return static_cast<std::size_t>(named - names.begin());
  }
  std::size_t number = 0;
  const char* const end = wanted.data() + wanted.size();
  const auto [rest, error] = std::from_chars(wanted.data(), end, number);
  return error == std::errc() && rest == end && number < names.size() ? std::optional(number)
                                                                      : std::nullopt;
}

}  // namespace raycat
