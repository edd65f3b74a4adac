#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <glm/vec4.hpp>

#include "antialias/adaptive.hpp"
#include "antialias/border.hpp"
#include "antialias/corner_labels.hpp"
#include "antialias/over_lattice.hpp"
#include "antialias/patch.hpp"
#include "antialias/square_region.hpp"

namespace raycat {

/// Smooths pixels one after the other on one worker. What it makes of a pixel depends on the
/// samples that are on the lattice around it.
class SquareSmoother {
 public:
  /// Keeps references. The lattice must have its corners, and units that can be halved as often as
  /// a border is followed.
  SquareSmoother(SampleLattice& lattice, const AdaptiveSettings& settings, bool covers, int worker)
      : lattice_(lattice), settings_(settings), covers_(covers), worker_(worker) {}

  /// What a pixel is, colour and alpha, and what it has put on its borders that was not there.
  struct Result {
    std::vector<TreeShare> shares;  ///< that sum to 1, if they are wanted; trees may be there twice
    glm::vec4 mean{0.0f};
    /// What the mean may be off by, as far as `AdaptiveSettings::error` has a say in it.
    float error = 0.0f;
    bool refined = false;
    std::array<bool, 4> borders{};  ///< left, right, above, below
    std::optional<Border> cut;      ///< the only border within it, if that is straight
  };
  Result smooth(int x, int y) { return smooth(x, y, settings_.error, nullptr); }

  /// The same with an error of its own, and what is where within the pixel, if that is wanted.
  Result smooth(int x, int y, float error, Patch* patch);

 private:
  // Where the border between two labels crosses a side.
  struct Crossing {
    float at = 0.5f;         // from the side's start, of its length
    float exact = 0.0f;      // how far it may be from there
    glm::vec4 before{0.0f};  // what is just before it and just after
    glm::vec4 after{0.0f};
  };

  void cover(TreeId tree, float share) {
    if (covers_) {
      result_.shares.push_back({.tree = tree, .share = share});
    }
  }
  glm::vec4 whole(const Square& square, const Corners& corners, const glm::vec4& mean,
                  float share = 1.0f);
  void may_be_off(float error) { result_.error = std::max(result_.error, error); }
  glm::vec2 place(const Square& square) const;
  const ColourSample& sample(const glm::ivec2& point);
  float area(const Square& square) const;

  glm::vec4 integrate(const Square& square);
  glm::vec4 part(const Square& square);
  bool cluttered(const Square& square);
  template <typename Visit>
  void for_each_around(const Square& square, const Visit& visit);
  bool meets_another(const Square& square, TreeId tree);
  std::optional<glm::vec4> as_smooth(const Square& square, const Corners& corners);
  glm::vec4 as_parts(const Square& square, const Corners& corners);
  std::optional<glm::vec4> as_one(const Square& square, const Corners& corners, float diff);
  std::optional<glm::vec4> as_two(const Square& square, const Corners& corners,
                                  const CornerLabels& labels);
  std::optional<Crossing> cross(const Square& square, const Corners& corners,
                                const CornerLabels& labels, int side, int steps);
  std::optional<Crossing> cross_cheaply(const Square& square, const Corners& corners,
                                        const std::array<SurfaceFit, 4>& surfaces,
                                        const CornerLabels& labels, int side, int steps);
  std::array<SurfaceFit, 4> surfaces_around(const Square& square, const Corners& corners,
                                            const CornerLabels& labels);

  SampleLattice& lattice_;
  const AdaptiveSettings& settings_;
  bool covers_;
  int worker_;
  float error_ = 0.0f;  // that is allowed in the pixel
  Patch* patch_ = nullptr;
  Result result_;
  std::vector<SampleLattice::OnSide> on_side_;
};

}  // namespace raycat
