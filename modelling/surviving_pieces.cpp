#include "modelling/surviving_pieces.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "csg/heavy_paths.hpp"
#include "geometry/disjoint_sets.hpp"
#include "geometry/edge_uses.hpp"
#include "modelling/sides.hpp"

namespace raycat {
namespace {

// Pieces that meet at an edge at which nothing else is survive together.
std::vector<std::uint32_t> patches(const Arrangement& arrangement) {
  std::vector<glm::uvec3> triangles;
  triangles.reserve(arrangement.pieces.size());
  for (const Arrangement::Piece& piece : arrangement.pieces) {
    triangles.push_back(piece.corners);
  }
  DisjointSets joined(triangles.size());
  const EdgeUses edges(triangles, arrangement.points.size());
  edges.for_each([&](std::span<const std::uint32_t> uses) {
    if (uses.size() == 2) {
      joined.join(uses.front() / 3, uses.back() / 3);
    }
  });
  std::vector<std::uint32_t> first(triangles.size());
  for (std::uint32_t piece = 0; piece < first.size(); ++piece) {
    first[piece] = joined.first(piece);
  }
  return first;
}

class Judge {
 public:
  Judge(const CsgTree& tree, const LeafTriangles& leaves)
      : tree_(tree),
        leaves_(leaves),
        paths_(tree),
        sides_(leaves.corners, leaves.mesh.triangles, leaves.wanted) {}

  Survival operator()(const Arrangement& arrangement, const Arrangement::Piece& piece) {
    const auto& points = arrangement.points;
    const Exact::Point_3 middle =
        CGAL::centroid(points[piece.corners.x], points[piece.corners.y], points[piece.corners.z]);
    const glm::uvec3& t = leaves_.mesh.triangles[piece.triangle];
    const glm::dvec3& corner = leaves_.mesh.positions[t.x];
    const glm::dvec3 across =
        glm::cross(leaves_.mesh.positions[t.y] - corner, leaves_.mesh.positions[t.z] - corner);
    sides_.pass(middle, across, passages_);
    std::ranges::sort(passages_, {}, [&](const Sides::Passage& passage) {
      return std::tuple(leaves_.leaf[passage.triangle], passage.triangle);
    });
    if (!take_sides()) {
      return Survival::gone;
    }
    const Sides::Passage& best = responsible();
    if (best.triangle != piece.triangle) {
      return Survival::gone;
    }
    return best.leaving == inside_before_ ? Survival::as_is : Survival::turned;
  }

 private:
  struct Change {
    std::uint32_t leaf = 0;
    bool leaving = false;
  };

  // Follows the line through the point. Returns whether it passes the solid's boundary there.
  bool take_sides() {
    state_.start(paths_);
    changes_.clear();
    for (std::size_t i = 0; i < passages_.size();) {
      const std::uint32_t leaf = leaves_.leaf[passages_[i].triangle];
      int after = 0;
      int before = 0;
      for (; i < passages_.size() && leaves_.leaf[passages_[i].triangle] == leaf; ++i) {
        const int turn = passages_[i].leaving ? 1 : -1;
        before += turn;
        after += passages_[i].here ? 0 : turn;
      }
      if (before > 0) {
        state_.toggle(leaf);
      }
      if ((before > 0) != (after > 0)) {
        changes_.push_back({.leaf = leaf, .leaving = before > 0});
      }
    }
    inside_before_ = state_.inside();
    state_.begin_group();
    bool changed = false;
    for (const Change& change : changes_) {
      changed = state_.toggle(change.leaf) != changed;
    }
    state_.end_group();
    return changed;
  }

  const Sides::Passage& responsible() const {
    const Sides::Passage* best = nullptr;
    const auto rank = [&](const Sides::Passage& passage) {
      const std::uint32_t leaf = leaves_.leaf[passage.triangle];
      return std::tuple(paths_.subtracted(leaf),
                        static_cast<std::uint32_t>(tree_.leaves()[leaf].first_face) +
                            leaves_.mesh.faces[passage.triangle],
                        passage.triangle);
    };
    for (const Sides::Passage& passage : passages_) {
      const std::uint32_t leaf = leaves_.leaf[passage.triangle];
      const auto change = std::ranges::lower_bound(changes_, leaf, {}, &Change::leaf);
      if (passage.here && change != changes_.end() && change->leaf == leaf &&
          change->leaving == passage.leaving && state_.responsible(leaf) &&
          (best == nullptr || rank(passage) < rank(*best))) {
        best = &passage;
      }
    }
    assert(best != nullptr);
    return *best;
  }

  const CsgTree& tree_;
  const LeafTriangles& leaves_;
  HeavyPaths paths_;
  HeavyPaths::State state_;
  Sides sides_;
  std::vector<Sides::Passage> passages_;
  std::vector<Change> changes_;
  bool inside_before_ = false;
};

}  // namespace

std::vector<Survival> surviving_pieces(const CsgTree& tree, const LeafTriangles& leaves,
                                       const Arrangement& arrangement) {
  Judge judge(tree, leaves);
  const std::vector<std::uint32_t> patch = patches(arrangement);
  std::vector<Survival> out(arrangement.pieces.size());
  for (std::uint32_t piece = 0; piece < out.size(); ++piece) {
    // A patch is numbered by its first piece.
    out[piece] =
        patch[piece] == piece ? judge(arrangement, arrangement.pieces[piece]) : out[patch[piece]];
  }
  return out;
}

}  // namespace raycat
