#include "io/openscad_program.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "io/excerpt.hpp"
#include "io/input_file.hpp"
#include "io/openscad_parser.hpp"
#include "io/scene_file.hpp"

namespace raycat::openscad {

namespace {

namespace fs = std::filesystem;

// A folder of its own, which goes with all that is in it.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "raycat-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      throw std::system_error(errno, std::generic_category(), name);
    }
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  fs::path operator/(const char* name) const { return path_ / name; }

 private:
  fs::path path_;
};

// What the program did: its exit status, or nothing if it is not there.
int run(const fs::path& file, const fs::path& out, const fs::path& log) {
  std::string program = "openscad";
  std::string option = "-o";
  std::string to = out.string();
  std::string from = fs::absolute(file).string();
  const std::array<char*, 5> arguments{program.data(), option.data(), to.data(), from.data(),
                                       nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, log.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) {
    throw LoadError(file, "",
                    "reading .scad needs the program openscad, which is not installed; where it "
                    "is, `openscad -o FILE.csg FILE.scad` makes a .csg file");
  }
  int status = error;
  while (error == 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

// The first line that says what went wrong.
std::string complaint(const fs::path& log) {
  std::ifstream in(log);
  std::string first;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("ERROR")) {
      return line;
    }
    first = first.empty() ? line : first;
  }
  return first.empty() ? "no reason given" : first;
}

}  // namespace

std::string csg_of_program(const fs::path& file) {
  const Folder folder;
  const fs::path out = folder / "out.csg";
  const fs::path log = folder / "log";
  const int status = run(file, out, log);
  const std::string said = complaint(log);
  if (status != 0 || said.starts_with("ERROR")) {
    throw LoadError(file, "", fmt::format("openscad says: {}", excerpt(said)));
  }
  return read_input_file(out, most_bytes);
}

}  // namespace raycat::openscad
