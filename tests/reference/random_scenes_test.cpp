// Scenes that nobody chose against the reference.

#include "reference/random_scenes.hpp"

#include <catch2/catch.hpp>

#include "reference/agreement.hpp"
#include "reference/effort.hpp"

namespace raycat::reference {
namespace {

constexpr int size = 24;

TEST_CASE("random scenes are as the reference has them", "[reference][random]") {
  int samples = 0;
  int excused = 0;
  for (unsigned seed = 0; seed < 100 / sparing; ++seed) {
    CAPTURE(seed);
    const Scene scene = random_scene(seed);
    const Agreement agreement = compare_with_reference(
        scene, scene.cameras.front(), {.width = size, .height = size, .levels = 6});
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

}  // namespace
}  // namespace raycat::reference
