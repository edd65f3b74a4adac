#include "edges/regions.hpp"

#include <limits>
#include <stdexcept>

namespace raycat {
namespace {

// Labels given out row by row, and which of them turned out to be one region. The least label of
// a region stands for it; that is the one its first pixel was given.
class Labels {
 public:
  std::uint32_t add() {
    parents_.push_back(static_cast<std::uint32_t>(parents_.size()));
    return parents_.back();
  }

  std::uint32_t least(std::uint32_t label) {
    while (parents_[label] != label) {
      parents_[label] = parents_[parents_[label]];
      label = parents_[label];
    }
    return label;
  }

  // Returns the label that stands for both from now on.
  std::uint32_t join(std::uint32_t a, std::uint32_t b) {
    a = least(a);
    b = least(b);
    const std::uint32_t both = std::min(a, b);
    parents_[std::max(a, b)] = both;
    return both;
  }

  std::size_t size() const { return parents_.size(); }

 private:
  std::vector<std::uint32_t> parents_;
};

}  // namespace

Regions connected_regions(const CategoryImage& categories) {
  Regions regions{.width = categories.width, .height = categories.height};
  const auto columns = static_cast<std::size_t>(regions.width);
  const std::size_t pixels = columns * static_cast<std::size_t>(regions.height);
  if (pixels > std::numeric_limits<std::uint32_t>::max()) {
    throw std::length_error("regions are found in images of at most 4294967295 pixels");
  }
  Labels labels;
  regions.labels.reserve(pixels);
  for (int y = 0; y < regions.height; ++y) {
    for (int x = 0; x < regions.width; ++x) {
      const CategoryId here = categories.at(x, y);
      const bool as_left = x > 0 && categories.at(x - 1, y) == here;
      const bool as_above = y > 0 && categories.at(x, y - 1) == here;
      const std::size_t i = regions.labels.size();
      const auto label_at = [&](std::size_t j) {
        return static_cast<std::uint32_t>(regions.labels[j]);
      };
      std::uint32_t label = 0;
      if (as_left && as_above) {
        label = labels.join(label_at(i - 1), label_at(i - columns));
      } else if (as_left || as_above) {
        label = label_at(as_left ? i - 1 : i - columns);
      } else {
        label = labels.add();
      }
      regions.labels.push_back(RegionId{label});
    }
  }

  // A label's least is before it, so it has its number by then.
  std::vector<std::uint32_t> number(labels.size());
  std::uint32_t next = 0;
  for (std::uint32_t label = 0; label < labels.size(); ++label) {
    const std::uint32_t least = labels.least(label);
    number[label] = least == label ? next++ : number[least];
  }
  regions.sizes.resize(next);
  regions.categories.resize(next);
  std::size_t i = 0;
  for (int y = 0; y < regions.height; ++y) {
    for (int x = 0; x < regions.width; ++x, ++i) {
      const std::uint32_t region = number[static_cast<std::size_t>(regions.labels[i])];
      regions.labels[i] = RegionId{region};
      ++regions.sizes[region];
      regions.categories[region] = categories.at(x, y);
    }
  }
  return regions;
}

}  // namespace raycat
