#include "tests/bench/povray_time.hpp"

#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>

#include "io/povray/program.hpp"

namespace raycat::bench {

bool povray_present() { return std::system("command -v povray > /dev/null 2>&1") == 0; }

std::optional<double> povray_trace_seconds(const std::string& scene, int image_side) {
  try {
    const auto run = run_povray(scene, {fmt::format("+W{}", image_side),
                                        fmt::format("+H{}", image_side), "+WT1", "-A", "-F"});
    return run ? std::optional(run->cpu) : std::nullopt;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

}  // namespace raycat::bench
