#pragma once

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace raycat {

/// Calls `work(row, worker)` once for each row from 0 to rows - 1, on `threads` threads at once;
/// `worker` is from 0 to threads - 1 and never two calls at once share it. Rows start in order.
/// An exception stops the rest and is thrown again here. The only place that starts threads.
template <typename Work>
void parallel_rows(int rows, int threads, const Work& work) {
  std::atomic<int> next = 0;
  std::exception_ptr error;
  std::mutex error_mutex;
  const auto run = [&](int worker) {
    try {
      for (int row = next++; row < rows; row = next++) {
        work(row, worker);
      }
    } catch (...) {
      const std::lock_guard lock(error_mutex);
      error = std::current_exception();
      next = rows;
    }
  };
  {
    std::vector<std::jthread> others;
    for (int worker = 1; worker < threads; ++worker) {
      others.emplace_back(run, worker);
    }
    run(0);
  }
  if (error) {
    std::rethrow_exception(error);
  }
}

}  // namespace raycat
