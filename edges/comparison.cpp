#include "edges/comparison.hpp"

#include <array>
#include <cassert>

namespace raycat {

Comparison compare(const CategoryImage& method, const CategoryImage& heap) {
  assert(method.width == heap.width && method.height == heap.height);
  Comparison result{.distinct = method.table.size()};
  for (int y = 0; y < heap.height; ++y) {
    for (int x = 0; x < heap.width; ++x) {
      bool edge = false;
      bool true_edge = false;
      for (const auto& [dx, dy] : {std::array{1, 0}, std::array{0, 1}, std::array{1, 1}}) {
        const bool differs = method.at(x, y) != method.at(x + dx, y + dy);
        const bool truly = heap.at(x, y) != heap.at(x + dx, y + dy);
        edge |= differs;
        true_edge |= truly;
        result.false_equalities += truly && !differs ? 1u : 0u;
      }
      result.edge_pixels += edge ? 1u : 0u;
      result.missed += true_edge && !edge ? 1u : 0u;
    }
  }
  return result;
}

}  // namespace raycat
