#include "io/openscad/touching_boxes.hpp"

#include <algorithm>
#include <numeric>

#include "geometry/disjoint_sets.hpp"

namespace raycat {

namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};

// A tree over the boxes, in which each box looks for those it touches. A branch whose boxes are
// all of the box's own group already is passed over, so that many boxes in one heap cost no more
// than many apart.
class TouchingBoxes {
 public:
  explicit TouchingBoxes(std::span<const Bounds> boxes)
      : boxes_(boxes), order_(boxes.size()), groups_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    build(0, static_cast<std::uint32_t>(boxes.size()));
  }

  std::vector<std::uint32_t> groups() {
    for (std::uint32_t box = 0; box < boxes_.size(); ++box) {
      join(0, box);
    }
    std::vector<std::uint32_t> number(boxes_.size(), none);
    std::vector<std::uint32_t> group(boxes_.size());
    std::uint32_t next = 0;
    for (std::uint32_t box = 0; box < boxes_.size(); ++box) {
      std::uint32_t& of_first = number[groups_.first(box)];
      if (of_first == none) {
        of_first = next++;
      }
      group[box] = of_first;
    }
    return group;
  }

 private:
  struct Branch {
    Bounds bounds;
    std::uint32_t second = none;  // the first child follows its parent; `none` at a leaf
    std::uint32_t member = none;  // any box of the one group that all are of, once they are
  };

  // Splits in halves, so that the recursion is as deep as the logarithm of the number of boxes.
  void build(std::uint32_t begin, std::uint32_t end) {
    const std::size_t at = branches_.size();
    Branch branch;
    for (std::uint32_t i = begin; i < end; ++i) {
      branch.bounds.include(boxes_[order_[i]]);
    }
    branch.member = end - begin == 1 ? order_[begin] : none;
    branches_.push_back(branch);
    if (end - begin == 1) {
      return;
    }
    const glm::dvec3 size = branch.bounds.half_size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                       return boxes_[a].min[axis] + boxes_[a].max[axis] <
                              boxes_[b].min[axis] + boxes_[b].max[axis];
                     });
    build(begin, middle);
    branches_[at].second = static_cast<std::uint32_t>(branches_.size());
    build(middle, end);
  }

  void join(std::uint32_t at, std::uint32_t box) {
    Branch& branch = branches_[at];
    if (intersection(branch.bounds, boxes_[box]).empty() ||
        (branch.member != none && groups_.first(branch.member) == groups_.first(box))) {
      return;
    }
    if (branch.second == none) {
      groups_.join(branch.member, box);
      return;
    }
    join(at + 1, box);
    join(branch.second, box);
    const std::uint32_t a = branches_[at + 1].member;
    const std::uint32_t b = branches_[branch.second].member;
    if (a != none && b != none && groups_.first(a) == groups_.first(b)) {
      branch.member = a;
    }
  }

  std::span<const Bounds> boxes_;
  std::vector<std::uint32_t> order_;
  DisjointSets groups_;
  std::vector<Branch> branches_;
};

}  // namespace

std::vector<std::uint32_t> group_touching(std::span<const Bounds> boxes) {
  if (boxes.empty()) {
    return {};
  }
  return TouchingBoxes(boxes).groups();
}

}  // namespace raycat
