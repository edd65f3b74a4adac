#pragma once

#include <utility>

namespace raycat::bench {

/// CPU seconds that the calling thread has used. What else runs on a shared machine changes it far
/// less than it does the wall clock.
double cpu_seconds();

/// The CPU seconds that `work` takes.
template <typename Work>
double timed(Work&& work) {
  const double start = cpu_seconds();
  std::forward<Work>(work)();
  return cpu_seconds() - start;
}

}  // namespace raycat::bench
