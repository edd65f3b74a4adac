#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "io/openscad/context.hpp"

namespace raycat::openscad {

/// The arguments of a node, found by name or by place. A wrong type throws `NodeError`; what is
/// unknown (`undef`, `nan`, `inf`) counts as absent.
class Parameters {
 public:
  /// `names` are those that arguments without a name stand for, in order. A name outside of it
  /// and of `others` is warned of.
  Parameters(Context& context, const Node& node, std::initializer_list<std::string_view> names,
             std::initializer_list<std::string_view> others);

  /// The value given last, or null.
  const Value* find(std::string_view name) const;

  double number(std::string_view name, double otherwise) const;
  bool flag(std::string_view name, bool otherwise) const;
  std::string text(std::string_view name, const std::string& otherwise) const;

  /// Throws if absent or no vector.
  const Vector& vector(std::string_view name) const;

  /// A radius, or half of a diameter if that is given.
  double radius(std::string_view by_radius, std::string_view by_diameter, double otherwise) const;

  /// A number for all of `count` axes, or a vector of a number each. What is unknown, and in a
  /// vector what comes after it, keeps its default.
  glm::dvec3 axes(std::string_view name, std::size_t count, const glm::dvec3& otherwise) const;

  /// $fn, $fa and $fs, each the file's where the node has none.
  FacetRule facets() const;

  /// The corners of a circle of this radius by `facets`.
  std::uint32_t corners(double radius) const;

  [[noreturn]] void fail(const std::string& what) const { Context::fail(node_, what); }

 private:
  Context& context_;
  const Node& node_;
  std::vector<std::string_view> names_;
};

}  // namespace raycat::openscad
