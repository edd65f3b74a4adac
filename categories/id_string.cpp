#include "categories/id_string.hpp"

namespace raycat {

IdString::IdString(const Extent& scene) : symbols_(scene) {
  require_within(scene, limits, "string");
}

void IdString::encode(std::span<const RayNode> tree, CategoryWords& words) const {
  words.clear();
  symbols_.list(tree, [&](std::uint32_t symbol) { words.push_back(symbol); });
}

}  // namespace raycat
