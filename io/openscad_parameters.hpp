#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "io/openscad_parser.hpp"

namespace raycat::openscad {

/// The arguments of a node, found by name or by place. A wrong type throws `LoadError`; what is
/// unknown (`undef`, `nan`, `inf`) counts as absent.
class Parameters {
 public:
  /// `names` are those that arguments without a name stand for, in order. A name outside of it
  /// and of `others` is warned of.
  Parameters(const std::filesystem::path& file, const Node& node,
             std::initializer_list<std::string_view> names,
             std::initializer_list<std::string_view> others, std::vector<std::string>& warnings);

  /// The value given last, or null.
  const Value* find(std::string_view name) const;

  double number(std::string_view name, double otherwise) const;
  bool flag(std::string_view name, bool otherwise) const;

  /// Throws if absent or no vector.
  const Vector& vector(std::string_view name) const;

  [[noreturn]] void fail(const std::string& what) const;

 private:
  const std::filesystem::path& file_;
  const Node& node_;
  std::vector<std::string_view> names_;
};

}  // namespace raycat::openscad
