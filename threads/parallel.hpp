#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
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

/// How many parts `parallel_parts` makes of so many small pieces of work: as many as threads,
/// but none that would not be worth starting one.
inline int part_count(std::size_t size, int threads) {
  constexpr std::size_t least_of_a_part = 16384;
  return static_cast<int>(std::clamp<std::size_t>(size / least_of_a_part, 1,
                                                  static_cast<std::size_t>(std::max(threads, 1))));
}

/// Calls `work(begin, end, part)` once for each part of the numbers below `size`, on as many
/// threads; parts are as long as each other and in order.
template <typename Work>
void parallel_parts(std::size_t size, int threads, const Work& work) {
  const int parts = part_count(size, threads);
  const auto begin = [&](int part) {
    return size * static_cast<std::size_t>(part) / static_cast<std::size_t>(parts);
  };
  parallel_rows(parts, parts, [&](int part, int) { work(begin(part), begin(part + 1), part); });
}

/// Calls `work(i)` once for each number below `size`, in such parts.
template <typename Work>
void parallel_each(std::size_t size, int threads, const Work& work) {
  parallel_parts(size, threads, [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t i = begin; i < end; ++i) {
      work(i);
    }
  });
}

}  // namespace raycat
