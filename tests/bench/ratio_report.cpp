#include "tests/bench/ratio_report.hpp"

#include <algorithm>
#include <functional>
#include <map>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <sys/resource.h>

namespace raycat::bench {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  if (values.size() % 2 == 1) {
    return *middle;
  }
  return 0.5 * (*std::max_element(values.begin(), middle) + *middle);
}

// Prints medians as the console does, and keeps every repetition's counters.
class Collector : public benchmark::ConsoleReporter {
 public:
  Collector() : ConsoleReporter(OO_Tabular) {}

  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> shown;
    for (const Run& run : runs) {
      failed_ = failed_ || run.error_occurred;
      if (run.error_occurred || run.repetitions == 1 || run.aggregate_name == "median") {
        shown.push_back(run);
      }
      if (run.run_type != Run::RT_Iteration || run.error_occurred) {
        continue;
      }
      for (const auto& [name, counter] : run.counters) {
        seconds_[run.run_name.function_name][name].push_back(counter.value);
      }
    }
    ConsoleReporter::ReportRuns(shown);
  }

  void print(const Ratio& ratio) const {
    const auto found = seconds_.find(ratio.benchmark);
    if (found == seconds_.end()) {
      return;  // filtered out or skipped
    }
    std::vector<double> ratios = found->second.at(ratio.over);
    std::ranges::transform(ratios, found->second.at(ratio.under), ratios.begin(), std::divides());
    fmt::print("{} {}/{} {:.3f}{}\n", ratio.benchmark, ratio.over, ratio.under, median(ratios),
               ratio.limit ? fmt::format(" (limit {})", *ratio.limit) : "");
  }

  bool failed() const noexcept { return failed_; }

 private:
  std::map<std::string, std::map<std::string, std::vector<double>>> seconds_;
  bool failed_ = false;
};

}  // namespace

int run(int argc, char** argv, const std::vector<Ratio>& ratios) {
  std::string repetitions = "--benchmark_repetitions=9";
  std::vector<char*> arguments(argv, argv + argc);
  arguments.insert(arguments.begin() + 1, repetitions.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) {
    return 2;
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  for (const Ratio& ratio : ratios) {
    collector.print(ratio);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  fmt::print("peak memory {:.1f} MB\n", static_cast<double>(usage.ru_maxrss) / 1024.0);
  return collector.failed() ? 1 : 0;
}

}  // namespace raycat::bench
