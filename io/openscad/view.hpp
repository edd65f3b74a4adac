#pragma once

#include <filesystem>
#include <optional>

#include "io/openscad/parser.hpp"
#include "tracer/camera.hpp"

namespace raycat::openscad {

/// Where OpenSCAD looks at a file from that sets nothing: a unit vector towards the eye.
glm::dvec3 default_direction();

/// The camera that `$vpt`, `$vpr` (degrees), `$vpd` and `$vpf` (degrees, of the image's height)
/// set, as OpenSCAD's window shows it; nothing if the file sets none of them. Those it does not
/// set have OpenSCAD's defaults. Throws `LoadError` for a value out of range.
std::optional<Camera> view(const std::filesystem::path& file, const File& parsed);

}  // namespace raycat::openscad
