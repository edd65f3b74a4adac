#include "render/coverage.hpp"

#include <algorithm>
#include <unordered_map>

#include "render/tree_table.hpp"

namespace raycat {
namespace {

struct Share {
  TreeId category{};
  float share = 0.0f;
};

void add(TreeId category, float share, std::vector<Share>& shares) {
  const auto known = std::ranges::find(shares, category, &Share::category);
  if (known == shares.end()) {
    shares.push_back({.category = category, .share = share});
  } else {
    known->share += share;
  }
}

}  // namespace

CoverageImage coverage_image(const AntialiasedPicture& picture,
                             const std::function<const RayTree&(TreeId)>& tree_of,
                             const SurfaceTable& surfaces, const Detail& detail, int ranks) {
  CoverageImage out{.width = picture.width, .height = picture.height, .ranks = ranks};
  const std::size_t count = picture.coverage.size() * static_cast<std::size_t>(ranks);
  out.ids.resize(count);
  out.shares.resize(count);
  TreeTable reduced;
  std::unordered_map<TreeId, TreeId> category_of;
  std::unordered_map<TreeId, std::uint32_t> number_of;
  std::vector<Share> shares;
  for (std::size_t pixel = 0; pixel < picture.coverage.size(); ++pixel) {
    shares.clear();
    for (const TreeShare& each : picture.coverage[pixel]) {
      const auto [known, fresh] = category_of.try_emplace(each.tree);
      if (fresh) {
        RayTree tree = tree_of(each.tree);
        reduce(tree, detail, surfaces);
        known->second = reduced.intern(tree);
      }
      add(known->second, std::max(each.share, 0.0f), shares);
    }
    std::ranges::stable_sort(shares, std::ranges::greater(), &Share::share);
    float sum = 0.0f;
    const std::size_t kept = std::min(shares.size(), static_cast<std::size_t>(ranks));
    for (std::size_t i = 0; i < kept; ++i) {
      sum += shares[i].share;
    }
    for (std::size_t i = 0; i < kept && shares[i].share > 0.0f; ++i) {
      const auto next = static_cast<std::uint32_t>(number_of.size()) + 1;
      const std::size_t at = pixel * static_cast<std::size_t>(ranks) + i;
      out.ids[at] = number_of.try_emplace(shares[i].category, next).first->second;
      out.shares[at] = shares[i].share / sum;
    }
  }
  out.categories = number_of.size();
  return out;
}

}  // namespace raycat
