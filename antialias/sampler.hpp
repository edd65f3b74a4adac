#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace raycat {

/// A ray tree, by number: two samples are of one category exactly when theirs are equal. Numbers
/// may differ from run to run, so that nothing else may be made of them.
enum class TreeId : std::uint32_t {};

/// What one ray through the image tells.
struct ColourSample {
  /// Linear, each channel from 0 to 1: what a display can show. Alpha is 1, or all is 0 where the
  /// background is left out.
  glm::vec4 colour{0.0f, 0.0f, 0.0f, 1.0f};
  TreeId tree{};
  bool textured = false;  ///< did the ray meet a textured surface on its way (Section 4.2)?
};

/// A picture that can be sampled at any point, in pixels from its top left corner, by any number
/// of workers at once. What a point tells depends on the point alone.
class Sampler {
 public:
  virtual ~Sampler() = default;

  virtual ColourSample sample(const glm::dvec2& point, int worker) = 0;

  /// Of which of two trees is the ray through the point, as far as they differ? Nothing if of
  /// neither. Traces no more of the ray's tree than tells them apart, and no light.
  virtual std::optional<TreeId> side(const glm::dvec2& point, TreeId a, TreeId b, int worker) = 0;

  /// Can `side` tell these two apart by less than a whole tree?
  virtual bool tells_cheaply(TreeId a, TreeId b) = 0;

  /// Calls `visit` with points, in pixels, at which there may be something so thin that the corners
  /// of pixels all miss it. Always the same, in the same order.
  virtual void thin(const std::function<void(const glm::dvec2&)>& visit) const {
    static_cast<void>(visit);
  }
};

}  // namespace raycat
