#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tracer/scene.hpp"

namespace raycat {

/// The picture that a file for POV-Ray is of.
struct PovPicture {
  Camera camera;
  int width = 512;
  int height = 512;
  int levels = 8;  ///< of the ray tree
};

/// Writes a scene for POV-Ray 3.7, set operations and all, so that it renders the picture that we
/// do; the file's first lines say with which command. Returns a line for each thing of the scene
/// that POV-Ray has no words for and that is therefore left out. Throws `std::runtime_error` if
/// the file cannot be written.
std::vector<std::string> write_pov(const std::filesystem::path& path, const Scene& scene,
                                   const PovPicture& picture);

}  // namespace raycat
