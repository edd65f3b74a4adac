#include "categories/recode.hpp"

namespace raycat {

CategoryImage recode(const CategoryImage& image, const Encoder& heap,
                     const std::function<void(RayTree& tree, CategoryWords& words)>& words_of) {
  CategoryImage result{.width = image.width, .height = image.height, .textured = image.textured};
  RayTree tree;
  CategoryWords words;
  std::vector<CategoryId> known;  // by the number in `image`, so that these stay in raster order
  known.reserve(image.table.size());
  for (std::size_t id = 0; id < image.table.size(); ++id) {
    decode(heap, image.table.words(CategoryId{static_cast<std::uint32_t>(id)}), tree);
    words_of(tree, words);
    known.push_back(result.table.intern(words));
  }
  result.samples.reserve(image.samples.size());
  for (const CategoryId sample : image.samples) {
    result.samples.push_back(known[static_cast<std::size_t>(sample)]);
  }
  return result;
}

CategoryImage recode(const CategoryImage& image, const Encoder& heap, const Detail& detail,
                     const SurfaceTable& surfaces, const Encoder& to) {
  return recode(image, heap, [&](RayTree& tree, CategoryWords& words) {
    reduce(tree, detail, surfaces);
    encode(to, tree, words);
  });
}

}  // namespace raycat
