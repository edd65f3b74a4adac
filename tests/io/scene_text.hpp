#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include "io/files/load_error.hpp"
#include "io/load_scene.hpp"

namespace raycat {

/// A folder of this process alone, since tests run side by side.
inline std::filesystem::path temporary_folder() {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("raycat-test-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  return folder;
}

/// A file in the temporary folder that is removed at the end.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, std::string_view content)
      : path_(temporary_folder() / name) {
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
    std::filesystem::remove(path_.parent_path(), ignored);  // if it is empty now
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
};

inline SceneFile load_text(const std::string& name, std::string_view content,
                           const LoadOptions& options = {}) {
  const TemporaryFile file(name, content);
  return load_scene(file.path(), options);
}

/// The message of the error that loading throws, without the folder; empty if none.
inline std::string load_error(const std::string& name, std::string_view content) {
  const TemporaryFile file(name, content);
  try {
    load_scene(file.path());
  } catch (const LoadError& error) {
    const std::string folder = file.path().parent_path().string() + "/";
    const std::string message = error.what();
    return message.starts_with(folder) ? message.substr(folder.size()) : message;
  }
  return "";
}

inline std::filesystem::path corpus() {
  const char* const folder = std::getenv("RAYCAT_CORPUS");
  return folder != nullptr ? folder : RAYCAT_CORPUS;
}

}  // namespace raycat
