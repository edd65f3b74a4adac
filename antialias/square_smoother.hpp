#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <glm/vec4.hpp>

#include "antialias/adaptive.hpp"
#include "antialias/border.hpp"
#include "antialias/over_lattice.hpp"

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
    bool refined = false;
    std::array<bool, 4> borders{};  ///< left, right, above, below
    std::optional<Border> cut;      ///< the only border within it, if that is straight
  };
  Result smooth(int x, int y);

 private:
  // Corners by label: those of one label are taken for one surface.
  struct Labels {
    std::array<int, 4> of{};
    int count = 0;
    float apart = 0.0f;  // the greatest distance of two corners of different labels
  };

  // Where the border between two labels crosses a side.
  struct Crossing {
    float at = 0.5f;         // from the side's start, of its length
    float exact = 0.0f;      // how far it may be from there
    glm::vec4 before{0.0f};  // what is just before it and just after
    glm::vec4 after{0.0f};
  };

  // A part of a square that has one label, in units of the square's side.
  struct Region {
    std::array<glm::vec2, 5> points{};
    std::array<glm::vec4, 5> values{};
    int size = 0;
    int label = 0;

    void add(const glm::vec2& point, const glm::vec4& value);
  };
  struct Integral {
    float area = 0.0f;
    glm::vec2 centre{0.0f};
    glm::vec4 mean{0.0f};
  };
  using Plane = std::array<glm::vec4, 3>;  // value, and its change along x and y

  void cover(TreeId tree, float share) {
    if (covers_) {
      result_.shares.push_back({.tree = tree, .share = share});
    }
  }
  glm::vec4 mean_of(const Square& square, const Corners& corners, float share = 1.0f);
  const ColourSample& sample(const glm::ivec2& point);
  float area(const Square& square) const;

  glm::vec4 integrate(const Square& square);
  glm::vec4 part(const Square& square);
  bool meets_another(const Square& square, TreeId tree);
  std::optional<glm::vec4> as_smooth(const Square& square, const Corners& corners);
  glm::vec4 as_parts(const Square& square, const Corners& corners);
  std::optional<glm::vec4> as_one(const Square& square, const Corners& corners, float diff);
  std::optional<glm::vec4> as_two(const Square& square, const Corners& corners,
                                  const Labels& labels);
  Labels label(const Corners& corners, float threshold) const;
  int label_of(const ColourSample& sample, const Corners& corners, const Labels& labels) const;
  // What the samples of a label show among the sixteen of a square and around it, one square's side
  // apart.
  struct Surface {
    std::optional<Plane> plane;  // that fits them best, if they tell one
    float range = 0.0f;          // how far their colours are apart at most
    glm::vec4 mean{0.0f};

    glm::vec4 at(const glm::vec2& point) const;
  };

  std::optional<Crossing> cross(const Square& square, const Corners& corners, const Labels& labels,
                                int side, int steps);
  std::optional<Crossing> cross_cheaply(const Square& square, const Corners& corners,
                                        const std::array<Surface, 4>& surfaces,
                                        const Labels& labels, int side, int steps);
  Surface surface(const Square& square, const Corners& corners, const Labels& labels, int label);
  static Integral integral(const Region& region);

  SampleLattice& lattice_;
  const AdaptiveSettings& settings_;
  bool covers_;
  int worker_;
  Result result_;
  std::vector<SampleLattice::OnSide> on_side_;
};

}  // namespace raycat
