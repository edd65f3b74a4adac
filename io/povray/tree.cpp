#include "io/povray/tree.hpp"

#include <string_view>
#include <vector>

namespace raycat {
namespace {

using Node = CsgTree::Node;

struct Place {
  std::vector<std::uint32_t> operands;
  std::uint32_t within = CsgTree::no_parent;  // the nearest operation that is written
  bool first = true;                          // is it the beginning of that operation?
  bool written = true;
};

// Which nodes are written, and where. Parents come after their operands, so they are looked at
// first.
std::vector<Place> places(const CsgTree& tree) {
  const auto nodes = tree.nodes();
  std::vector<Place> out(nodes.size());
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].parent != CsgTree::no_parent) {
      out[nodes[i].parent].operands.push_back(i);
    }
  }
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const Node& node = nodes[i];
    Place& place = out[i];
    if (node.parent != CsgTree::no_parent) {
      const Place& parent = out[node.parent];
      place.within = parent.written ? node.parent : parent.within;
      place.first = parent.operands.front() == i && (parent.written || parent.first);
    }
    if (node.leaf != CsgTree::no_leaf) {
      continue;
    }
    const bool goes_on = place.within != CsgTree::no_parent &&
                         nodes[place.within].operation == node.operation &&
                         (node.operation != Operation::difference || place.first);
    place.written = place.operands.size() > 1 && !goes_on;
  }
  return out;
}

std::string_view word(Operation operation, bool merge) {
  switch (operation) {
    case Operation::set_union:
      return merge ? "merge {" : "union {";
    case Operation::intersection:
      return "intersection {";
    case Operation::difference:
      break;
  }
  return "difference {";
}

}  // namespace

std::string pov_tree(const CsgTree& tree, bool merge,
                     const std::function<std::string(const CsgLeaf& leaf, std::size_t i)>& open) {
  const std::vector<Place> all = places(tree);
  std::string text;
  struct Step {
    std::uint32_t node = 0;
    bool done = false;  // all that is below it is written
  };
  std::vector<Step> steps{{.node = static_cast<std::uint32_t>(all.size() - 1)}};
  while (!steps.empty()) {
    const Step step = steps.back();
    steps.pop_back();
    const Node& node = tree.nodes()[step.node];
    const Place& place = all[step.node];
    if (step.done) {
      text += "}\n";
    } else if (node.leaf != CsgTree::no_leaf) {
      text += open(tree.leaves()[node.leaf], node.leaf) + " }\n";
    } else {
      if (place.written) {
        text += word(node.operation, merge);
        text += '\n';
        steps.push_back({.node = step.node, .done = true});
      }
      for (auto i = place.operands.rbegin(); i != place.operands.rend(); ++i) {
        steps.push_back({.node = *i});
      }
    }
  }
  text.resize(text.size() - 2);  // the root's own closing brace and line end
  return text;
}

}  // namespace raycat
