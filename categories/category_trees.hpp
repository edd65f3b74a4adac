#pragma once

#include <optional>
#include <vector>

#include "categories/category_image.hpp"
#include "raytree/ray_tree.hpp"

namespace raycat {

/// The ray trees that the categories of an image stand for: each is read back from its words when
/// it is first asked for, and kept.
class CategoryTrees {
 public:
  /// Keeps a reference to `image`.
  explicit CategoryTrees(const CategoryImage& image) : image_(image), trees_(image.table.size()) {}

  const CategoryImage& image() const noexcept { return image_; }

  /// As the category keeps it, without weights. Not while another thread asks. Throws
  /// `std::logic_error` unless a heap encoder made the words.
  const RayTree& tree(CategoryId id);

 private:
  const CategoryImage& image_;
  std::vector<std::optional<RayTree>> trees_;  // by category
};

}  // namespace raycat
