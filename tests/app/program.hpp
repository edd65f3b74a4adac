#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <sys/wait.h>

#include "support/temporary_folder.hpp"

namespace raycat {

struct Outcome {
  int code = -1;
  std::string out;
  std::string err;
};

inline std::string read_file(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// Runs a shell command.
inline Outcome shell(const std::string& command) {
  const TemporaryFolder folder;
  const int status = std::system(
      fmt::format("({}) >'{}' 2>'{}'", command, folder / "out", folder / "err").c_str());
  return {.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          .out = read_file(folder / "out"),
          .err = read_file(folder / "err")};
}

/// Runs raycat with arguments as a shell takes them.
inline Outcome raycat(const std::string& arguments) {
  return shell(fmt::format("'{}' {}", RAYCAT_PROGRAM, arguments));
}

inline std::string scene(const std::string& name) {
  return fmt::format("'{}/scenes/{}.gltf'", RAYCAT_ASSETS, name);
}

}  // namespace raycat
