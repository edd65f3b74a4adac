#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

namespace raycat {

struct Outcome {
  int code = -1;
  std::string out;
  std::string err;
};

/// A folder of its own for a test, empty at first and gone afterwards.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = std::filesystem::temp_directory_path() / "raycat-XXXXXX";
    path_ = ::mkdtemp(name.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return *this / name;
  }

  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  std::filesystem::path path_;
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
