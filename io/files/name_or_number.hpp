#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace raycat {

/// Which of `names` a user means: the first that is `wanted`, else the one of that number, from 0.
std::optional<std::size_t> name_or_number(std::span<const std::string> names,
                                          const std::string& wanted);

}  // namespace raycat
