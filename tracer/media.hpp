#pragma once

#include <array>
#include <cassert>
#include <cstddef>

#include <glm/vec3.hpp>

#include "raytree/ray_tree.hpp"
#include "raytree/surface_table.hpp"

namespace raycat {

/// The transparent objects that a ray is inside of, the innermost last: nested dielectrics, told
/// by where rays enter and leave. Around all of them is the air, of index 1, which absorbs nothing.
class Media {
 public:
  Media() = default;
  Media(const Media& other) noexcept { *this = other; }
  Media& operator=(const Media& other) noexcept {
    count_ = other.count_;
    aimed_ = other.aimed_;
    for (std::size_t i = 0; i < count_; ++i) {
      inside_[i] = other.inside_[i];
    }
    return *this;
  }

  /// Index of refraction of what the ray travels in, or is aimed into.
  float ior() const noexcept {
    return aimed() ? aimed_ : count_ == 0 ? 1.0f : inside_[count_ - 1].ior;
  }

  /// Where surfaces of several objects coincide, a ray is refracted at the first, straight into the
  /// medium behind all of them, of this index, until it passes the next.
  void aim(float ior) noexcept { aimed_ = ior; }
  bool aimed() const noexcept { return aimed_ != 0.0f; }

  /// Is the ray inside of `object`, but travels in another that it entered later?
  bool within_another_than(ObjectId object) const noexcept {
    for (std::size_t i = 0; i + 1 < count_; ++i) {
      if (inside_[i].object == object) {
        return inside_[count_ - 1].object != object;
      }
    }
    return false;
  }

  /// Of what the ray travels in: light that goes a distance d is times exp(-absorption d).
  const glm::vec3& absorption() const noexcept {
    static constexpr glm::vec3 none(0.0f);
    return count_ == 0 ? none : inside_[count_ - 1].absorption;
  }

  /// With the ray gone into `object`.
  Media entered(ObjectId object, float ior,
                const glm::vec3& absorption = glm::vec3(0.0f)) const noexcept {
    assert(count_ < inside_.size());
    Media media(*this);
    media.aimed_ = 0.0f;
    media.inside_[media.count_++] = {.object = object, .ior = ior, .absorption = absorption};
    return media;
  }

  /// With the ray gone out of `object`, wherever in the nesting that is. As it was if the ray
  /// was not inside: it started there.
  Media left(ObjectId object) const noexcept {
    Media media(*this);
    media.aimed_ = 0.0f;
    for (std::size_t i = media.count_; i-- > 0;) {
      if (media.inside_[i].object == object) {
        --media.count_;
        for (; i < media.count_; ++i) {
          media.inside_[i] = media.inside_[i + 1];
        }
        break;
      }
    }
    return media;
  }

 private:
  struct Inside {
    ObjectId object;
    float ior;
    glm::vec3 absorption;
  };

  std::size_t count_ = 0;
  float aimed_ = 0.0f;                      // 0: it is not
  std::array<Inside, most_levels> inside_;  // a ray enters at most one a level
};

}  // namespace raycat
