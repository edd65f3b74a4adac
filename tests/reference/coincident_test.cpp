// Objects that share surfaces, against the reference, which has the rule from its definition
// (docs/design.md, Coincident surfaces).

#include <catch2/catch.hpp>

#include "geometry/tessellate.hpp"
#include "reference/agreement.hpp"
#include "reference/coincident_scenes.hpp"
#include "reference/effort.hpp"
#include "support/scenes.hpp"

namespace raycat::reference {
namespace {

constexpr int size = 24;

TEST_CASE("surfaces of several objects in one are met in the order that the reference has",
          "[reference][coincident]") {
  int samples = 0;
  int excused = 0;
  for (unsigned seed = 0; seed < 60 / sparing; ++seed) {
    CAPTURE(seed);
    const Scene scene = coincident_scene(seed);
    const Agreement agreement = compare_with_reference(scene, scene.cameras.front(),
                                                       {.width = size, .height = size, .levels = 6},
                                                       {.straight_out_of_overlap = true});
    INFO(agreement.first);
    CHECK(agreement.trees == 0);
    CHECK(agreement.edges == 0);
    CHECK(agreement.colours == 0);
    samples += agreement.samples;
    excused += agreement.excused;
  }
  CAPTURE(samples, excused);
  CHECK(excused * 200 < samples);
}

TEST_CASE("a camera exactly on a surface looks through it", "[reference][coincident]") {
  SceneBuilder builder;
  const MaterialId stone = builder.material({.diffuse = glm::vec3(0.5f)});
  const Shape box = Box{.size = glm::dvec3(2.0)};
  if (GENERATE(false, true)) {
    builder.mesh("box", {.triangles = tessellate(box, 0.1)}, at(0, 0, 0), stone);
  } else {
    builder.shape("box", box, at(0, 0, 0), stone);
  }
  const Scene scene = builder.light({.position = {0, 0, 0}}).take();
  const glm::dvec3 target = GENERATE(glm::dvec3(0, 0, 0), glm::dvec3(0.5, 0.2, 5));
  const Agreement agreement = compare_with_reference(
      scene, look_at({0.3, 0.2, 1}, target, {0, 1, 0}), {.width = size, .height = size});
  INFO(agreement.first);
  CHECK(agreement.trees == 0);
  CHECK(agreement.colours == 0);
}

}  // namespace
}  // namespace raycat::reference
