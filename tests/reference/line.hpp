#pragma once

#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

// The reference counts in long double, which keeps 11 bits more than the program's double.
namespace raycat::reference {

using Real = long double;
using Vec = glm::vec<3, Real>;
using Matrix = glm::mat<3, 3, Real>;

/// The points origin + t direction, for all t.
struct Line {
  Vec origin{0.0L};
  Vec direction{0.0L, 0.0L, -1.0L};

  Vec at(Real t) const { return origin + t * direction; }
};

/// A passage of a line through a surface.
struct Passage {
  Real t = 0.0L;
  Vec normal{0.0L};        ///< unit, out of the solid
  std::uint32_t face = 0;  ///< of the shape, from 0
};

}  // namespace raycat::reference
