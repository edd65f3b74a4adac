#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tracer/scene.hpp"

namespace raycat {

/// Leaves of a tree whose surfaces have the material of another leaf, as `cut_material` asks.
class CutMaterials {
 public:
  /// Leaves from `begin` to before `end` have the material of `base`, which is not one of them.
  void add(std::size_t begin, std::size_t end, std::size_t base) {
    cuts_.push_back({.begin = begin, .end = end, .base = base});
  }

  /// Gives the leaves their materials. Of cuts in cuts the outermost counts, whose base none of
  /// them holds.
  void apply(std::vector<MaterialId>& materials) {
    std::ranges::sort(cuts_, [](const Cut& a, const Cut& b) {
      return a.begin != b.begin ? a.begin < b.begin : a.end > b.end;
    });
    std::size_t covered = 0;
    for (const Cut& cut : cuts_) {
      for (; covered < cut.end; ++covered) {
        if (covered >= cut.begin) {
          materials[covered] = materials[cut.base];
        }
      }
    }
  }

 private:
  struct Cut {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t base = 0;
  };

  std::vector<Cut> cuts_;
};

}  // namespace raycat
