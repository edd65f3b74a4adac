#pragma once

#include <optional>
#include <string>

namespace raycat::bench {

bool povray_present();

/// The CPU seconds that POV-Ray says it traces the file `scene` in, on one thread, without
/// antialiasing, at `image_side` squared. None if it fails.
std::optional<double> povray_trace_seconds(const std::string& scene, int image_side);

}  // namespace raycat::bench
