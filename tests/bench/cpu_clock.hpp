#pragma once

#include <utility>

namespace raycat::bench {

/// CPU seconds that the calling thread has used. What else runs on a shared machine changes it far
/// less than it does the wall clock.
double cpu_seconds();

/// CPU seconds that all threads of the process have used, for work that others share in.
double process_cpu_seconds();

/// Wall-clock seconds.
double wall_seconds();

/// The CPU seconds that `work` takes.
template <typename Work>
double timed(Work&& work, double (*seconds)() = cpu_seconds) {
  const double start = seconds();
  std::forward<Work>(work)();
  return seconds() - start;
}

}  // namespace raycat::bench
