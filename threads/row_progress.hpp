#pragma once

#include <atomic>
#include <functional>
#include <mutex>

namespace raycat {

/// Reports rows as they are done, one call at a time; a worker that finds another one reporting
/// goes on.
class RowProgress {
 public:
  RowProgress(const std::function<void(int done, int rows)>& report, int rows)
      : report_(report), rows_(rows) {}

  void row_done() {
    const int done = ++done_;
    if (report_) {
      if (const std::unique_lock lock(mutex_, std::try_to_lock); lock || done == rows_) {
        report_(done, rows_);
      }
    }
  }

 private:
  const std::function<void(int, int)>& report_;
  int rows_;
  std::atomic<int> done_ = 0;
  std::mutex mutex_;
};

}  // namespace raycat
