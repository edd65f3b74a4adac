#pragma once

#include <vector>

#include "raytree/ray_tree.hpp"
#include "reference/surroundings.hpp"

namespace raycat::reference {

/// What there is of one sample.
struct Traced {
  RayTree tree;  ///< without weights
  Vec colour{0.0L};
};

/// What docs and program may settle either way.
struct Rules {
  int levels = 8;
  /// A light counts only where O_d or O_s is not zero.
  bool lights_by_factors = true;
  /// Rays but those to lights pass the back faces of single-sided materials.
  bool back_faces_unseen = true;
  /// Leaving an object that is not the innermost which the ray is in changes no direction.
  bool straight_out_of_overlap = true;
};

/// Eq. (1) and the ray tree (Section 2.1), recursively, as docs/materials.md has them.
class Tracing {
 public:
  Tracing(const Surroundings& around, const Rules& rules) : around_(around), rules_(rules) {}

  Traced operator()(const Line& line) const;

 private:
  /// The transparent objects that a ray is inside of, the innermost last.
  struct Medium {
    ObjectId object{};
    Real ior = 1.0L;
    Vec absorption{0.0L};
  };
  using Media = std::vector<Medium>;

  /// How a ray goes through a surface; nothing of it does on total internal reflection.
  struct Passing {
    std::optional<Vec> direction;
    Media media;  ///< beyond the surface
  };

  Vec trace(const Way& way, const Media& media, HeapPosition position, bool bent,
            RayTree& tree) const;
  Passing pass(const Vec& direction, const Meeting& hit, const Vec& normal,
               const std::vector<Meeting>& place, const Media& media, bool bent) const;

  /// What of the light arrives at a hit, with the way towards it; nothing of one not visible.
  Vec arriving(const Light& light, const Meeting& hit, const Vec& point, const Vec& normal,
               const Vec& facet, const Vec& lifted, Vec& towards) const;
  Vec let_through(const Way& way, Real end) const;

  static Media with(const Media& media, const Meeting& hit);

  const Surroundings& around_;
  Rules rules_;
};

}  // namespace raycat::reference
