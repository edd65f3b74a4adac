#pragma once

#include <filesystem>
#include <string>

namespace raycat::openscad {

/// The .csg text that the `openscad` program makes of a .scad file. Throws `LoadError` with the
/// program's own words if it cannot, or saying that the program is not installed.
std::string csg_of_program(const std::filesystem::path& file);

}  // namespace raycat::openscad
