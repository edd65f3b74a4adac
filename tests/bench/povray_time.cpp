#include "tests/bench/povray_time.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

namespace raycat::bench {

bool povray_present() { return std::system("command -v povray > /dev/null 2>&1") == 0; }

// CPU seconds of the trace, from the lines
//     Trace Time:       0 hours  0 minutes  0 seconds (0.221 seconds)
//                 using 1 thread(s) with 0.219 CPU-seconds total
std::optional<double> povray_trace_seconds(const std::string& scene, int image_side) {
  const std::string command =
      fmt::format("povray +I'{}' +W{} +H{} +WT1 -A -D -V -F 2>&1", scene, image_side, image_side);
  std::FILE* output = popen(command.c_str(), "r");
  if (output == nullptr) {
    return std::nullopt;
  }
  std::optional<double> seconds;
  bool tracing = false;
  std::array<char, 512> line{};
  while (std::fgets(line.data(), static_cast<int>(line.size()), output) != nullptr) {
    const std::string text = line.data();
    tracing = text.find("Time:") == std::string::npos
                  ? tracing
                  : text.find("Trace Time:") != std::string::npos;
    double cpu = 0.0;
    if (tracing &&
        std::sscanf(line.data(), " using %*d thread(s) with %lf CPU-seconds", &cpu) == 1) {
      seconds = cpu;
    }
  }
  return pclose(output) == 0 ? seconds : std::nullopt;
}

}  // namespace raycat::bench
