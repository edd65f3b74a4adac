#include "categories/recode.hpp"

namespace raycat {

CategoryImage recode(
    CategoryTrees& trees,
    const std::function<void(const RayTree& tree, CategoryWords& words)>& words_of) {
  const CategoryImage& image = trees.image();
  CategoryImage result{.width = image.width,
                       .height = image.height,
                       .textured = image.textured,
                       .detail = image.detail};
  CategoryWords words;
  std::vector<CategoryId> known;  // by the number in `image`, so that these stay in raster order
  known.reserve(image.table.size());
  for (std::size_t id = 0; id < image.table.size(); ++id) {
    words_of(trees.tree(CategoryId{static_cast<std::uint32_t>(id)}), words);
    known.push_back(result.table.intern(words));
  }
  result.samples.reserve(image.samples.size());
  for (const CategoryId sample : image.samples) {
    result.samples.push_back(known[static_cast<std::size_t>(sample)]);
  }
  return result;
}

CategoryImage recode(CategoryTrees& trees, const Detail& detail, const SurfaceTable& surfaces,
                     const Encoder& to) {
  RayTree kept;
  CategoryImage result = recode(trees, [&](const RayTree& tree, CategoryWords& words) {
    kept = tree;
    reduce(kept, detail, surfaces);
    encode(to, kept, words);
  });
  result.encoder = to;
  result.detail = detail;
  return result;
}

}  // namespace raycat
