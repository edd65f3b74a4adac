#include "app/interrupt.hpp"

#include <atomic>
#include <csignal>

#include <unistd.h>

namespace raycat::app {
namespace {

// A signal handler can reach nothing but what is global and free of locks.
std::atomic<bool> delayed = false;
std::atomic<bool> pending = false;
static_assert(std::atomic<bool>::is_always_lock_free);

[[noreturn]] void end() {
  constexpr char line[] = "raycat: interrupted\n";
  if (::write(STDERR_FILENO, line, sizeof line - 1) < 0) {
    ::_exit(1);  // nobody is there to read it
  }
  ::_exit(1);
}

void on_signal(int /*signal*/) {
  pending = true;
  if (!delayed) {
    end();
  }
}

}  // namespace

void handle_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

InterruptDelay::InterruptDelay() { delayed = true; }

InterruptDelay::~InterruptDelay() {
  delayed = false;
  if (pending) {
    end();
  }
}

}  // namespace raycat::app
