#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace raycat {

/// A path expression that cannot be read: where, and what was expected there.
struct PathError : std::invalid_argument {
  PathError(std::size_t column_in, const std::string& expected)
      : std::invalid_argument("column " + std::to_string(column_in) + ": " + expected),
        column(column_in) {}

  std::size_t column;  ///< from 1, in code units of the text
};

}  // namespace raycat
