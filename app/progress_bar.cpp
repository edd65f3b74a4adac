#include "app/progress_bar.hpp"

#include <cstdio>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

namespace raycat::app {

ProgressBar::ProgressBar(std::string label, bool quiet)
    : label_(std::move(label)), wanted_(!quiet && ::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (shown_) {
    fmt::print(stderr, "\r\033[K");
    std::fflush(stderr);
  }
}

std::function<void(int, int)> ProgressBar::callback() {
  if (!wanted_) {
    return {};
  }
  return [this](int done, int total) { show(done, total); };
}

void ProgressBar::show(int done, int total) {
  constexpr auto interval = std::chrono::milliseconds(50);
  constexpr int cells = 40;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < interval && done != total) {
    return;
  }
  last_ = now;
  shown_ = true;
  const int full = static_cast<int>(static_cast<long long>(cells) * done / total);
  fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {:3}%", label_, "", full, "", cells - full,
             static_cast<int>(100LL * done / total));
  std::fflush(stderr);
}

}  // namespace raycat::app
