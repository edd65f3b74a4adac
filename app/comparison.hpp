#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "edges/comparison.hpp"
#include "render/render.hpp"

namespace raycat::app {

/// A row of Table 1.
struct MethodResult {
  std::string method;  ///< heap, string, primes or godel

  std::uint64_t edge_pixels = 0;
  std::uint64_t missed = 0;            ///< edge pixels of heap that the method does not select
  std::uint64_t false_equalities = 0;  ///< neighbouring samples that only heap tells apart
  std::uint64_t distinct = 0;          ///< categories

  std::uint64_t overflowed = 0;     ///< pixels whose number does not fit 64 bits
  std::uint64_t overflowed_80 = 0;  ///< nor 80 bits
  std::uint64_t bytes = 0;          ///< held by the categories, samples and table
  double trace_seconds = 0.0;       ///< CPU seconds of a render with the method, median
  double ratio_to_none = 0.0;       ///< median of that over one without categories beside it
};

/// The paper's Table 1 for one scene. Primes are compared by their exact products, so that what
/// they miss is what the method cannot tell apart; `machine_word` is the same with products
/// modulo 2^64.
struct MethodTable {
  std::uint64_t pixels = 0;
  double none_seconds = 0.0;  ///< CPU seconds of a render without categories, median
  std::vector<MethodResult> methods;
  Comparison machine_word;
};

/// Renders with each method and with none, taking turns row by row, `repetitions` times. Times are
/// of one thread each, whatever `settings.threads`; ratios are per sample.
MethodTable compare_methods(const Accel& accel, const Camera& camera,
                            const RenderSettings& settings, int repetitions);

}  // namespace raycat::app
