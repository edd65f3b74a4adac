#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tracer/material.hpp"

namespace raycat {

/// A material for a glTF file: its constants of eq. (1) as `whitted` extras, and beside them PBR
/// factors that look like them to viewers that know no more. Adds the extensions it uses to
/// `extensions`, and to `warnings` what a file cannot keep of it.
nlohmann::ordered_json material_json(const Material& material, std::vector<std::string>& extensions,
                                     std::vector<std::string>& warnings);

/// A colour as an array.
nlohmann::ordered_json colour_json(const glm::vec3& colour);

}  // namespace raycat
