#pragma once

#include <span>

#include "categories/category.hpp"
#include "categories/symbols.hpp"

namespace raycat {

/// The string method (Section 2.1.1): all symbols of the tree, one after the other, a word each.
/// Without refraction two trees have the same string only if they are the same tree; with it, some
/// different trees have the same string (Fig. 4).
class IdString {
 public:
  static constexpr Extent limits{
      .levels = 64, .lights = 64, .surfaces = (std::uint64_t{1} << 32) - 65};

  /// Throws `std::length_error`, naming the count, if `scene` is past `limits`.
  explicit IdString(const Extent& scene);

  /// Sets `words` to the symbols of `tree`.
  void encode(std::span<const RayNode> tree, CategoryWords& words) const;

 private:
  Symbols symbols_;
};

}  // namespace raycat
