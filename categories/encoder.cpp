#include "categories/encoder.hpp"

namespace raycat {

Encoder heap_encoder(const Extent& scene) {
  if (within(scene, PackedHeap::limits)) {
    return PackedHeap(scene);
  }
  return WideHeap(scene);
}

void encode(const Encoder& encoder, std::span<const RayNode> tree, CategoryWords& words) {
  std::visit([&](const auto& heap) { heap.encode(tree, words); }, encoder);
}

}  // namespace raycat
