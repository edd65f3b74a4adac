#pragma once

#include <optional>
#include <string>
#include <vector>

namespace raycat::bench {

/// What is said of a benchmark whose counters are CPU seconds: one over another, the median of
/// the repetitions' ratios. A repetition takes all counters, one soon after the other, so that
/// what slows a shared machine for a while slows both alike.
struct Ratio {
  std::string benchmark;
  std::string over;
  std::string under;
  std::optional<double> limit;  ///< at most this is wanted; told, not enforced
};

/// Runs the registered benchmarks, 9 repetitions unless the arguments say otherwise, and prints
/// the ratios and this process's peak memory. Returns the program's exit code.
int run(int argc, char** argv, const std::vector<Ratio>& ratios);

}  // namespace raycat::bench
