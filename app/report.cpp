#include "app/report.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

namespace raycat::app {

void print(const std::string& text) {
  if (std::fputs(text.c_str(), stdout) < 0 || std::fputc('\n', stdout) < 0 ||
      std::fflush(stdout) != 0) {
    throw std::runtime_error(
        fmt::format("standard output: cannot write: {}", std::generic_category().message(errno)));
  }
}

std::string printable(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return text;
}

std::string dump(const nlohmann::ordered_json& value, int indent) {
  return value.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

void warn(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    fmt::print(stderr, "raycat: warning: {}\n", printable(warning));
  }
}

nlohmann::ordered_json to_json(const Bounds& bounds) {
  if (bounds.empty()) {
    return nullptr;
  }
  return {{"min", {bounds.min.x, bounds.min.y, bounds.min.z}},
          {"max", {bounds.max.x, bounds.max.y, bounds.max.z}}};
}

std::uint64_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

double Stopwatch::lap() {
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::duration<double> seconds = now - last_;
  last_ = now;
  return seconds.count();
}

}  // namespace raycat::app
