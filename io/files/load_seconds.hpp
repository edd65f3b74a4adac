#pragma once

#include <chrono>

namespace raycat {

/// Where the time goes that reading a glTF file takes, in seconds. What is not among these is the
/// rest: nodes, lights, putting the scene together.
struct LoadSeconds {
  double parse = 0.0;       ///< from disk, JSON, checks of everything, base64
  double decompress = 0.0;  ///< Draco and meshopt
  double images = 0.0;      ///< from disk and decoded
  double meshes = 0.0;      ///< vertices and triangles taken from accessors
  double faces = 0.0;       ///< welded and joined into faces
};

/// Adds the time from its making to its end to a sum.
class SpentTime {
 public:
  explicit SpentTime(double& seconds) : seconds_(seconds) {}
  ~SpentTime() {
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  SpentTime(const SpentTime&) = delete;
  SpentTime& operator=(const SpentTime&) = delete;

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace raycat
