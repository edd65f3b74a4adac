#pragma once

#include <string>
#include <vector>

#include "tracer/scene.hpp"

namespace raycat {

/// How much stronger the lights' specular light is than their diffuse light, over all of them:
/// POV-Ray's have one colour for both, ours have two.
float specular_to_diffuse(const std::vector<Light>& lights);

/// The texture that a material of eq. (1) is in POV-Ray's language: it says the same thing, but for
/// image textures, and for highlights, which are as strong as lights are on the average and if they
/// are coloured fade to white at grazing angles.
std::string pov_texture(const Material& material, float specular_ratio);

/// The clause that an object whose inside is this material needs, with a blank before it; nothing
/// if rays go straight through.
std::string pov_interior(const Material& material);

}  // namespace raycat
