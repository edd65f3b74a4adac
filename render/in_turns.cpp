#include "render/in_turns.hpp"

#include <condition_variable>
#include <ctime>
#include <exception>
#include <mutex>

#include "threads/parallel.hpp"

namespace raycat {
namespace {

// Who comes first in a round finds the caches cold that the others find warm, so all are first in
// turn.
class Turns {
 public:
  explicit Turns(std::size_t sides) : finished_(sides) {}

  void wait(std::size_t side) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return turn_ == side || abandoned_; });
  }

  // After an error nobody waits for turns any more: those that have not begun never will.
  void abandon() {
    const std::lock_guard lock(mutex_);
    abandoned_ = true;
    changed_.notify_all();
  }

  void pass(std::size_t side, bool finished) {
    const std::lock_guard lock(mutex_);
    finished_[side] = finished;
    const std::size_t sides = finished_.size();
    for (std::size_t k = 0; k < 2 * sides; ++k) {
      ++step_;
      turn_ = (step_ / sides + step_) % sides;
      if (!finished_[turn_]) {
        break;
      }
    }
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<bool> finished_;
  std::size_t step_ = 0;  // turns so far; each round of them begins one side later than the last
  std::size_t turn_ = 0;
  bool abandoned_ = false;
};

// Passes the turn on when the render ends.
class Side {
 public:
  Side(Turns& turns, std::size_t side)
      : turns_(turns), side_(side), exceptions_(std::uncaught_exceptions()) {
    turns_.wait(side_);
  }
  ~Side() {
    if (std::uncaught_exceptions() > exceptions_) {
      turns_.abandon();
    }
    turns_.pass(side_, true);
  }
  Side(const Side&) = delete;
  Side& operator=(const Side&) = delete;

  void let_others() {
    turns_.pass(side_, false);
    turns_.wait(side_);
  }

 private:
  Turns& turns_;
  std::size_t side_;
  int exceptions_;
};

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

std::vector<double> cpu_seconds_in_turns(const std::vector<TimedRender>& renders,
                                         const RenderSettings& settings) {
  const int count = static_cast<int>(renders.size());
  std::vector<double> seconds(renders.size());
  Turns turns(renders.size());
  parallel_rows(count, count, [&](int row, int) {
    const auto i = static_cast<std::size_t>(row);
    Side side(turns, i);
    double start = thread_seconds();
    RenderSettings own(settings);
    own.threads = 1;
    own.progress = [&](int done, int rows) {
      seconds[i] += thread_seconds() - start;
      if (i == 0 && settings.progress) {
        settings.progress(done, rows);
      }
      side.let_others();
      start = thread_seconds();
    };
    renders[i](own);
    seconds[i] += thread_seconds() - start;
  });
  return seconds;
}

}  // namespace raycat
