#pragma once

#include <filesystem>
#include <vector>

namespace raycat {

/// Heights row by row, the first row at y = 0.
using HeightRows = std::vector<std::vector<double>>;

/// Reads the height map of OpenSCAD's surface(): a PNG, or a text of a line of numbers a row, in
/// which # begins a comment. `invert` counts for images. Throws `std::runtime_error` with the
/// reason alone.
HeightRows read_heights(const std::filesystem::path& file, bool invert);

}  // namespace raycat
