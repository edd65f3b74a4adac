// Path expressions: the first byte says which ray tree they filter, the rest is the expression.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "categories/path_expression.hpp"
#include "support/random_trees.hpp"

namespace raycat {
namespace {

struct Names {
  Names() {
    for (const char* name : {"ball", "it's", "floor"}) {
      surfaces.add_object(name);
      surfaces.add_primitive(name, 1);
    }
  }

  SurfaceTable surfaces;
  std::vector<std::string> lights{"key", "\"sun\""};
};

void filter(std::string_view text, std::uint8_t choice) {
  static const Names names;
  static const std::vector<RayTree> trees = all_trees({.levels = 2, .surfaces = 3, .lights = 2});
  try {
    const PathExpression expression(text, names.surfaces, names.lights);
    for (std::size_t i = choice; i < trees.size(); i += 256) {
      RayTree tree = trees[i];
      expression.filter(tree, names.surfaces);
      // What is left is part of what was there.
      if (tree.size() > trees[i].size()) {
        std::abort();
      }
    }
  } catch (const PathError&) {
  }
}

}  // namespace
}  // namespace raycat

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 0) {
    raycat::filter({reinterpret_cast<const char*>(data) + 1, size - 1}, data[0]);
  }
  return 0;
}
