#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "antialias/adaptive.hpp"
#include "antialias/border.hpp"
#include "antialias/corner_labels.hpp"
#include "antialias/patch.hpp"
#include "antialias/pixel_samples.hpp"
#include "antialias/thin_points.hpp"

namespace raycat {

/// Antialiases pixels one after the other on one worker. What it makes of a pixel depends on the
/// samples that are on the lattice around it.
class SquareAntialiaser {
 public:
  /// Keeps references. The lattice must have its corners, and units that can be halved as often as
  /// a border is followed.
  SquareAntialiaser(SampleLattice& lattice, const ThinPoints& thin,
                    const AdaptiveSettings& settings, bool covers, int worker)
      : samples_(lattice, settings, worker), thin_(thin), covers_(covers) {}

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

  /// With the error that is allowed, and if it is wanted, what is where within the pixel. Stays
  /// until the next pixel.
  Result& antialias(int x, int y, float error, Patch* patch);

 private:
  void cover(TreeId tree, float share) {
    if (covers_) {
      result_.shares.push_back({.tree = tree, .share = share});
    }
  }
  glm::vec4 whole(const Square& square, const Corners& corners, const glm::vec4& mean,
                  float share = 1.0f);
  void may_be_off(float error) { result_.error = std::max(result_.error, error); }
  glm::vec2 place(const Square& square) const;

  glm::vec4 integrate(const Square& square, const Corners& corners);
  glm::vec4 subdivide(const Square& square, const Corners& corners);
  bool cluttered(const Square& square);
  template <typename Test>
  bool all_on_sides(const Square& square, const Test& test);
  bool meets_another(const Square& square, TreeId tree);
  template <typename Expected>
  bool find_thin(const Square& square, const Expected& expected);
  std::optional<glm::vec4> as_smooth(const Square& square, const Corners& corners);
  glm::vec4 as_parts(const Square& square, const Corners& corners);
  std::optional<glm::vec4> as_one(const Square& square, const Corners& corners, float greatest);
  std::optional<glm::vec4> as_two(const Square& square, const Corners& corners,
                                  const CornerLabels& labels);

  PixelSamples samples_;
  const ThinPoints& thin_;
  std::span<const glm::ivec2> thin_here_;  // in the pixel
  bool found_thin_ = false;                // has the pixel something that its corners missed?
  bool covers_;
  Patch* patch_ = nullptr;
  Result result_;
  std::vector<SampleLattice::OnSide> on_side_;
};

}  // namespace raycat
