#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace raycat::app {

/// A bar on stderr that shows how far a render is: on a terminal, and nothing elsewhere.
class ProgressBar {
 public:
  ProgressBar(std::string label, bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// To be called with what is done of how much.
  std::function<void(int, int)> callback();

 private:
  void show(int done, int total);

  std::string label_;
  bool shown_ = false;
  bool wanted_;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace raycat::app
