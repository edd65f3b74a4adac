#pragma once

#include <string_view>

#include "categories/path_syntax.hpp"

namespace raycat::paths {

inline constexpr std::size_t most_text = 4096;  ///< code units of an expression
inline constexpr int most_nesting = 64;         ///< parentheses within parentheses
inline constexpr int most_repeats = 64;         ///< a counted repetition; no path is longer

/// Reads a path expression, without asking whether its names exist. Throws `PathError`, also where
/// what it matches could begin without C or have a C elsewhere.
PathSyntax parse(std::string_view text);

}  // namespace raycat::paths
