#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace raycat::openscad {

/// The most of a .csg file.
inline constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 28;

struct Value;
using Vector = std::vector<Value>;

/// `undef`, `nan` and infinite numbers are all unknown to OpenSCAD: the parameter takes its
/// default.
struct Unknown {};

struct Value {
  std::variant<Unknown, bool, double, std::string, Vector> is;

  const double* number() const noexcept { return std::get_if<double>(&is); }
  const Vector* vector() const noexcept { return std::get_if<Vector>(&is); }
};

/// `name = value`, or a value alone, with an empty name.
struct Argument {
  std::string_view name;
  Value value;
};

/// `name(arguments) { children }`.
struct Node {
  std::string_view name{};
  std::vector<Argument> arguments{};
  std::uint32_t line = 0;    ///< from 1
  std::uint32_t parent = 0;  ///< index into `File::nodes`
  std::uint32_t end = 0;     ///< one past the last descendant
  bool background = false;
  bool root = false;
  bool disabled = false;
};

/// `$name = value;` at the top level.
struct Assignment {
  std::string_view name;
  Value value;
  std::uint32_t line = 0;
};

/// All nodes in the order of the text, parents before their children. Node 0 is the file itself:
/// a `group` around all others. Flat, so that nesting costs no stack.
struct File {
  std::vector<Node> nodes;
  std::vector<Assignment> assignments;
};

/// Reads the text of a .csg file, whose names stay views into `text`. Throws `LoadError`, with
/// the line and what was expected there.
File parse(const std::filesystem::path& file, std::string_view text);

}  // namespace raycat::openscad
