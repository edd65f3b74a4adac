#pragma once

#include "geometry/placed_shape.hpp"
#include "reference/line.hpp"

namespace raycat::reference {

/// An affine map, inverted in long double.
class Place {
 public:
  explicit Place(const Affine& affine)
      : linear_(glm::dmat3(affine.matrix())),
        inverse_(glm::inverse(linear_)),
        translation_(affine.translation()) {}

  Line to_local(const Line& line) const {
    return {.origin = inverse_ * (line.origin - translation_),
            .direction = inverse_ * line.direction};
  }
  Vec point(const Vec& local) const { return linear_ * local + translation_; }
  Vec normal(const Vec& local) const { return glm::normalize(glm::transpose(inverse_) * local); }

 private:
  Matrix linear_;
  Matrix inverse_;
  Vec translation_;
};

}  // namespace raycat::reference
