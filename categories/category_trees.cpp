#include "categories/category_trees.hpp"

#include <stdexcept>

namespace raycat {

const RayTree& CategoryTrees::tree(CategoryId id) {
  std::optional<RayTree>& tree = trees_[static_cast<std::size_t>(id)];
  if (!tree) {
    if (!image_.encoder) {
      throw std::logic_error("categories of an unknown encoder cannot be read back as trees");
    }
    decode(*image_.encoder, image_.table.words(id), tree.emplace());
  }
  return *tree;
}

}  // namespace raycat
