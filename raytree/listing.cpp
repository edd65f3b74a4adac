#include "raytree/listing.hpp"

#include <algorithm>

namespace raycat {

void sort_as_listed(RayTree& tree) {
  std::ranges::sort(tree, [](const RayNode& a, const RayNode& b) {
    return listed_before(a.position, b.position);
  });
}

}  // namespace raycat
