#pragma once

namespace raycat::app {

/// From now on SIGINT and SIGTERM end the program with one line on stderr and exit code 1,
/// leaving no partial file.
void handle_interrupts();

/// While one lives, the end that a signal asks for waits until it is gone: for the moments when
/// a file is being written.
class InterruptDelay {
 public:
  InterruptDelay();
  ~InterruptDelay();
  InterruptDelay(const InterruptDelay&) = delete;
  InterruptDelay& operator=(const InterruptDelay&) = delete;
};

}  // namespace raycat::app
