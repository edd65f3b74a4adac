#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "antialias/sampler.hpp"

namespace raycat {

/// A picture given by a function of the point.
class Picture : public Sampler {
 public:
  using Function = std::function<ColourSample(const glm::dvec2& point)>;

  explicit Picture(Function function) : function_(std::move(function)) {}

  ColourSample sample(const glm::dvec2& point, int /*worker*/) override { return function_(point); }

  std::optional<TreeId> side(const glm::dvec2& point, TreeId a, TreeId b, int /*worker*/) override {
    const TreeId met = function_(point).tree;
    return met == a || met == b ? std::optional(met) : std::nullopt;
  }

  bool tells_cheaply(TreeId /*a*/, TreeId /*b*/) override { return cheap; }

  bool cheap = false;

 private:
  Function function_;
};

/// One colour where `inside` says so, and where it does not, nothing, or another.
inline Picture two_colours(const std::function<bool(const glm::dvec2&)>& inside,
                           const glm::vec4& in = glm::vec4(1.0f),
                           const glm::vec4& out = glm::vec4(0.0f)) {
  return Picture([=](const glm::dvec2& point) -> ColourSample {
    const bool is = inside(point);
    return {.colour = is ? in : out, .tree = TreeId{is ? 1u : 0u}};
  });
}

}  // namespace raycat
