// The scenes of assets/ against the reference.

#include <string>

#include <catch2/catch.hpp>

#include "raycat/scene_view.hpp"
#include "reference/agreement.hpp"
#include "reference/effort.hpp"

namespace raycat::reference {
namespace {

constexpr int size = sparing == 1 ? 32 : 12;

TEST_CASE("the scenes of assets are as the reference has them", "[reference][assets]") {
  const std::string name =
      GENERATE("fig1.gltf", "fig3.gltf", "fig4.gltf", "fig7.gltf", "fig8.gltf", "fig9.gltf",
               "fig10.gltf", "composite.gltf", "csg_part.gltf", "fence.gltf", "mesh_csg.gltf",
               "sphereflake.gltf", "bracket.csg", "flange.csg", "gear.csg");
  CAPTURE(name);
  const SceneView view(std::string(RAYCAT_ASSETS) + "/scenes/" + name);
  const Agreement agreement = compare_with_reference(view.scene(), view.camera(size, size),
                                                     {.width = size, .height = size, .levels = 6});
  INFO(agreement.first);
  CHECK(agreement.trees == 0);
  CHECK(agreement.edges == 0);
  CHECK(agreement.colours == 0);
  CHECK(agreement.excused * 200 < agreement.samples);
}

}  // namespace
}  // namespace raycat::reference
