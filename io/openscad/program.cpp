#include "io/openscad/program.hpp"

#include <fstream>
#include <optional>

#include <fmt/format.h>

#include "io/files/excerpt.hpp"
#include "io/files/input_file.hpp"
#include "io/files/load_error.hpp"
#include "io/files/other_program.hpp"
#include "io/openscad/parser.hpp"

namespace raycat::openscad {

namespace {

namespace fs = std::filesystem;

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
  const ScratchFolder folder;
  const fs::path out = folder / "out.csg";
  const fs::path log = folder / "log";
  const std::optional<int> status =
      run_program({"openscad", "-o", out.string(), fs::absolute(file).string()}, log);
  if (!status) {
    throw LoadError(file, "",
                    "reading .scad needs the program openscad, which is not installed; where it "
                    "is, `openscad -o FILE.csg FILE.scad` makes a .csg file");
  }
  const std::string said = complaint(log);
  if (*status != 0 || said.starts_with("ERROR")) {
    throw LoadError(file, "", fmt::format("openscad says: {}", excerpt(said)));
  }
  return read_input_file(out, most_bytes);
}

}  // namespace raycat::openscad
