#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace raycat {

/// A folder of its own for what is handed to another program, which goes with all that is in it.
class ScratchFolder {
 public:
  /// Throws `std::system_error` if it cannot be made.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// Runs a program, which is looked for as a shell does, with nothing to read and all that it prints
/// in `log`; `words` are its name and what it is given. Returns its wait status, 0 for success;
/// nothing if it is not installed.
std::optional<int> run_program(std::vector<std::string> words, const std::filesystem::path& log);

}  // namespace raycat
