#include "antialias/plain_pixel.hpp"

#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "antialias/pictures.hpp"
#include "antialias/square_antialiaser.hpp"

namespace raycat {
namespace {

constexpr int side = 5;
constexpr int units = 1024;

TEST_CASE("a plain pixel is what a square antialiaser makes of it", "[antialias][property]") {
  int plain_ones = 0;
  CHECK(rc::check("waves", [&] {
    const auto random = [] { return *rc::gen::inRange(-100, 101) / 100.0; };
    const glm::dvec2 wave(random(), random());
    const double height = std::abs(random());
    Picture picture([=](const glm::dvec2& p) -> ColourSample {
      const double v = 0.5 + 0.5 * height * std::sin(wave.x * p.x + wave.y * p.y);
      return {.colour = {v, v * v, 1.0 - v, 1.0}, .tree = TreeId{p.x > 8.0 ? 2u : 1u}};
    });
    SampleLattice lattice(picture, side, side, units, 1);
    lattice.trace_corners(1);
    const ThinPoints nothing_thin;
    const AdaptiveSettings settings{.error = 0.01f};
    SquareAntialiaser antialiaser(lattice, nothing_thin, settings, false, 0);
    if (const auto plain = plain_pixel(lattice, 2, 2, settings.error)) {
      ++plain_ones;
      const SquareAntialiaser::Result& whole = antialiaser.antialias(2, 2, settings.error, nullptr);
      RC_ASSERT_FALSE(whole.refined);
      RC_ASSERT(whole.error <= plain->error + 1e-6f);
      for (int channel = 0; channel < 4; ++channel) {
        RC_ASSERT(std::abs(whole.mean[channel] - plain->mean[channel]) < 1e-6f);
      }
    }
  }));
  CHECK(plain_ones > 20);
}

TEST_CASE("a pixel is plain only if all around it is", "[antialias]") {
  const auto is_plain = [](const glm::dvec2& odd_one, bool sampled) {
    Picture picture([=](const glm::dvec2& p) -> ColourSample {
      return {.colour = glm::vec4(0.5f), .tree = TreeId{p == odd_one ? 2u : 1u}};
    });
    SampleLattice lattice(picture, side, side, units, 1);
    lattice.trace_corners(1);
    if (sampled) {
      lattice.at(glm::ivec2(3 * units, 2 * units + 1), 0);
    }
    return plain_pixel(lattice, 2, 2, 0.01f).has_value();
  };
  CHECK(is_plain({0, 0}, false));
  CHECK(is_plain({1, 1}, false));
  CHECK_FALSE(is_plain({0, 0}, true));
  CHECK_FALSE(is_plain({2, 1}, false));
  CHECK_FALSE(is_plain({4, 3}, false));
  CHECK_FALSE(is_plain({3, 3}, false));
}

}  // namespace
}  // namespace raycat
