#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "geometry/bounds.hpp"

namespace raycat::app {

/// Prints `text` and a line end to stdout. Throws `std::runtime_error` if it cannot be written.
void print(const std::string& text);

/// `text` with a question mark for each control character, so that names cannot steer a terminal.
std::string printable(std::string text);

/// Text of `value`, on one line or indented; what is not UTF-8 in names is replaced.
std::string dump(const nlohmann::ordered_json& value, int indent = -1);

/// Prints each warning as a line on stderr.
void warn(const std::vector<std::string>& warnings);

/// {"min":[x,y,z],"max":[x,y,z]}, or null for empty bounds.
nlohmann::ordered_json to_json(const Bounds& bounds);

/// The most memory this process has had so far, in bytes.
std::uint64_t peak_memory();

/// Seconds since it was made or last read.
class Stopwatch {
 public:
  double lap();

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace raycat::app
