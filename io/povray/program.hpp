#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace raycat {

/// What POV-Ray says about a picture that it has traced.
struct PovrayRun {
  double rays = 0.0;  ///< through the image
  double cpu = 0.0;   ///< seconds of tracing
};

/// Runs `povray`, without display and pauses, on a scene file with these options besides. Nothing
/// if it is not installed; throws `std::runtime_error` if it fails.
std::optional<PovrayRun> run_povray(const std::filesystem::path& scene,
                                    const std::vector<std::string>& options);

}  // namespace raycat
