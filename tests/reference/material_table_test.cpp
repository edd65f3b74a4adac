// The table of docs/materials.md, read once more.

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "reference/line.hpp"
#include "support/random_trees.hpp"
#include "tracer/material.hpp"
#include "tracer/pbr.hpp"

namespace raycat::reference {
namespace {

double share() { return draw_below(1001) / 1000.0; }

glm::dvec3 colour() { return {share(), share(), share()}; }

TEST_CASE("materials are what the table makes of glTF's parameters", "[reference][materials]") {
  CHECK(rc::check([] {
    const Pbr pbr{.base = colour(),
                  .metallic = share(),
                  .roughness = share(),
                  .occlusion = share(),
                  .emission = colour(),
                  .ior = 1.0 + share(),
                  .specular = share(),
                  .specular_colour = colour(),
                  .transmission = draw_below(2) == 0 ? 0.0 : share(),
                  .attenuation_colour = 0.1 + 0.9 * colour(),
                  .attenuation_distance = 0.1 + share(),
                  .thin = draw_below(2) == 0};
    const Material material = whitted(pbr);
    const auto same = [](float a, Real b) { return std::abs(a - b) <= 1e-5L * (1.0L + b); };
    const Real r = pbr.roughness;
    const Real n = r == 0.0L ? 1024.0L : std::clamp(2.0L / std::pow(r, 4.0L) - 2.0L, 1.0L, 1024.0L);
    const Real polish = r <= 0.3L ? 1.0L - r / 0.3L : 0.0L;
    const Real m = pbr.metallic;
    const Real t = pbr.transmission;
    const Real facing = std::pow((Real(pbr.ior) - 1.0L) / (Real(pbr.ior) + 1.0L), 2.0L);
    Real greatest = 0.0L;
    for (int c = 0; c < 3; ++c) {
      greatest = std::max(
          greatest, std::min(facing * Real(pbr.specular_colour[c]), 1.0L) * Real(pbr.specular));
    }
    RC_ASSERT(same(material.shininess, n));
    RC_ASSERT(material.thin == pbr.thin);
    RC_ASSERT(same(material.ior, pbr.ior));
    for (int c = 0; c < 3; ++c) {
      const Real b = pbr.base[c];
      const Real dielectric = std::min(facing * Real(pbr.specular_colour[c]), 1.0L) * pbr.specular;
      const Real f0 = dielectric * (1.0L - m) + b * m;
      const Real diffuse = b * (1.0L - m) * (1.0L - t) * (1.0L - greatest);
      RC_ASSERT(same(material.emission[c], pbr.emission[c]));
      RC_ASSERT(same(material.diffuse[c], diffuse));
      RC_ASSERT(same(material.ambient[c], diffuse * Real(pbr.occlusion)));
      RC_ASSERT(same(material.specular[c], std::min(1.0L, f0 * (n + 8.0L) / 8.0L)));
      RC_ASSERT(same(material.reflection[c], f0 * polish));
      RC_ASSERT(same(material.transmission[c], t * (1.0L - m) * (1.0L - f0) * b));
      RC_ASSERT(material.fresnel == (pbr.transmission > 0.0 && pbr.roughness <= 0.3));
      if (material.fresnel) {
        RC_ASSERT(same(material.grazing_reflection[c], polish));
      }
      if (!pbr.thin) {
        const Real left = std::exp(-Real(material.absorption[c]) * pbr.attenuation_distance);
        RC_ASSERT(std::abs(left - Real(pbr.attenuation_colour[c])) < 1e-5L);
      }
    }
  }));
}

}  // namespace
}  // namespace raycat::reference
