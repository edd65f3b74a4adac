#include "antialias/plain_pixel.hpp"

#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace raycat {
namespace {

// The second differences along two lines of four samples, whose middle two are a side's ends.
struct Differences {
  glm::vec4 sum{0.0f};
  glm::vec4 greatest{0.0f};  // of each channel

  void add(const glm::vec4& before, const glm::vec4& a, const glm::vec4& b,
           const glm::vec4& after) {
    const glm::vec4 at_a = before - 2.0f * a + b;
    const glm::vec4 at_b = after - 2.0f * b + a;
    sum += at_a + at_b;
    greatest = glm::max(greatest, glm::max(glm::abs(at_a), glm::abs(at_b)));
  }
};

}  // namespace

std::optional<PlainPixel> plain_pixel(const SampleLattice& lattice, int x, int y, float error) {
  if (x < 1 || y < 1 || x + 2 > lattice.width() || y + 2 > lattice.height() ||
      lattice.refined(x, y)) {
    return std::nullopt;
  }
  const ColourSample* above = lattice.corner_row(y - 1) + x;
  const ColourSample* top = lattice.corner_row(y) + x;
  const ColourSample* bottom = lattice.corner_row(y + 1) + x;
  const ColourSample* below = lattice.corner_row(y + 2) + x;
  const TreeId tree = top[0].tree;
  for (const ColourSample* corner : {top - 1, top + 1, top + 2, bottom - 1, bottom, bottom + 1,
                                     bottom + 2, above, above + 1, below, below + 1}) {
    if (corner->tree != tree) {
      return std::nullopt;
    }
  }
  Differences across;
  across.add(top[-1].colour, top[0].colour, top[1].colour, top[2].colour);
  across.add(bottom[-1].colour, bottom[0].colour, bottom[1].colour, bottom[2].colour);
  Differences down;
  down.add(above[0].colour, top[0].colour, bottom[0].colour, below[0].colour);
  down.add(above[1].colour, top[1].colour, bottom[1].colour, below[1].colour);
  if (across.greatest.a + down.greatest.a > 0.0f) {
    return std::nullopt;
  }
  // No less than the greatest that `magnitude` has of any of them.
  constexpr float third = 1.0f / 3.0f;
  constexpr float twelfth = 1.0f / 12.0f;
  const auto bound = [](const glm::vec4& greatest) {
    return std::sqrt(third *
                     (greatest.r * greatest.r + greatest.g * greatest.g + greatest.b * greatest.b));
  };
  const float may_be_off = twelfth * (bound(across.greatest) + bound(down.greatest));
  if (may_be_off > error) {
    return std::nullopt;
  }
  const glm::vec4 mean =
      0.25f * ((top[0].colour + top[1].colour) + (bottom[0].colour + bottom[1].colour));
  return PlainPixel{.mean = mean - 0.25f * twelfth * (across.sum + down.sum), .error = may_be_off};
}

}  // namespace raycat
