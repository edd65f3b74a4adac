#pragma once

#include <string>
#include <string_view>

namespace raycat {

// OpenMesh's readers are made for well-formed files: others make them loop without end, skip
// what they cannot read, or open the files that a file names. These bring a file's bytes into
// the plain form that the readers understand; what has none throws `std::invalid_argument`. PLY
// files have a file of their own, `plain_ply.hpp`.

/// The `v` lines with three numbers and the `f` lines with one index a corner.
std::string plain_obj(std::string_view bytes);

/// A line each for the header, the counts, every vertex and every face, without colours. Binary
/// files are left as they are.
std::string plain_off(std::string_view bytes);

/// Whether an STL file is binary. Checks that the file is as long as its number of triangles
/// says, or, if it is text, that all facets are whole.
bool is_binary_stl(std::string_view bytes);

}  // namespace raycat
