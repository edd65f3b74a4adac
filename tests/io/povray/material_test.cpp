#include "io/povray/material.hpp"

#include <catch2/catch.hpp>

namespace raycat {
namespace {

TEST_CASE("an opaque material of eq. (1) is one layer in POV-Ray's words", "[io][pov]") {
  // The ambient light of POV-Ray is multiplied with the pigment, O_d: O_a / O_d is left.
  CHECK(pov_texture({.ambient = {0.25f, 0.5f, 0.5f},
                     .diffuse = {0.5f, 0.25f, 0.5f},
                     .specular = glm::vec3(0.25f),
                     .shininess = 40.0f,
                     .reflection = {0.5f, 0.0f, 0.125f}},
                    2.0f) ==
        "texture { pigment { rgb <0.5, 0.25, 0.5> } finish { ambient rgb <0.5, 2, 1> diffuse 1 "
        "reflection { rgb <0.5, 0, 0.125> } specular 0.5 roughness 0.025 } }");
}

TEST_CASE("what a material lets through is coloured below the layer of its own light",
          "[io][pov]") {
  const std::string text = pov_texture(
      {.diffuse = glm::vec3(0.25f), .transmission = {0.5f, 0.25f, 0.125f}, .ior = 1.5f}, 1.0f);
  CHECK(text ==
        "texture { pigment { rgb <1, 0.5, 0.25> filter 1 } finish { ambient 0 diffuse 0 } }\n"
        "texture { pigment { rgb <0.5, 0.5, 0.5> transmit 0.5 } finish { ambient rgb <0, 0, 0> "
        "diffuse 1 } }");
}

TEST_CASE("rays are bent by a material that is not thin", "[io][pov]") {
  Material glass{.transmission = glm::vec3(1.0f), .ior = 1.5f};
  CHECK(pov_interior(glass) == " interior { ior 1.5 }");
  glass.thin = true;
  CHECK(pov_interior(glass).empty());
  CHECK(pov_interior({.ior = 1.5f}).empty());
}

TEST_CASE("highlights follow the lights' own specular light", "[io][pov]") {
  CHECK(specular_to_diffuse({}) == 1.0f);
  const std::vector<Light> lights{{.diffuse = glm::vec3(0.5f), .specular = glm::vec3(1.0f)},
                                  {.diffuse = glm::vec3(0.5f), .specular = glm::vec3(2.0f)}};
  CHECK(specular_to_diffuse(lights) == 3.0f);
}

}  // namespace
}  // namespace raycat
