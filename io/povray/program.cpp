#include "io/povray/program.hpp"

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>

#include "io/files/other_program.hpp"

namespace raycat {
namespace {

// From what POV-Ray prints:
//     Pixels:             4352   Samples:           16384   Smpls/Pxl: 3.76
//     Trace Time:       0 hours  0 minutes  0 seconds (0.221 seconds)
//                 using 1 thread(s) with 0.219 CPU-seconds total
// Pixels have one ray each, and samples are those beyond it.
PovrayRun statistics(const std::filesystem::path& log) {
  PovrayRun run;
  std::ifstream in(log);
  bool tracing = false;
  for (std::string line; std::getline(in, line);) {
    double pixels = 0.0;
    double samples = 0.0;
    if (std::sscanf(line.c_str(), "Pixels: %lf Samples: %lf", &pixels, &samples) == 2) {
      run.rays = pixels + samples;
    }
    tracing = line.find("Time:") == std::string::npos
                  ? tracing
                  : line.find("Trace Time:") != std::string::npos;
    double cpu = 0.0;
    if (tracing &&
        std::sscanf(line.c_str(), " using %*d thread(s) with %lf CPU-seconds", &cpu) == 1) {
      run.cpu = cpu;
    }
  }
  return run;
}

}  // namespace

std::optional<PovrayRun> run_povray(const std::filesystem::path& scene,
                                    const std::vector<std::string>& options) {
  const ScratchFolder folder;
  const std::filesystem::path log = folder / "log";
  std::vector<std::string> words{"povray", "+I" + scene.string(), "-D", "-V"};
  words.insert(words.end(), options.begin(), options.end());
  const std::optional<int> status = run_program(words, log);
  if (!status) {
    return std::nullopt;
  }
  if (*status != 0) {
    throw std::runtime_error(fmt::format("povray: it failed on {}", scene.string()));
  }
  return statistics(log);
}

}  // namespace raycat
