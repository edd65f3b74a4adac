#pragma once

#include <functional>
#include <string>

#include "csg/tree.hpp"

namespace raycat {

/// A CSG tree as nested set operations in POV-Ray's language, without the last closing brace.
/// `open` gives a leaf's text without its closing brace. Operations on one operand are left out,
/// and one that goes on from where its parent begins is one with it, so that a chain of a million
/// operations is a list: POV-Ray calls itself for each level. `merge` takes the surfaces between
/// united operands away, which matters where one can see them.
std::string pov_tree(const CsgTree& tree, bool merge,
                     const std::function<std::string(const CsgLeaf& leaf, std::size_t i)>& open);

}  // namespace raycat
