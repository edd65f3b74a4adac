#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/program.hpp"

namespace raycat {
namespace {

// The lines of a document's code that start with `program` and run it, as a reader would type them.
std::vector<std::string> commands_of(const std::string& document, const std::string& program) {
  std::istringstream text(read_file(std::filesystem::path(RAYCAT_SOURCE) / document));
  std::vector<std::string> commands;
  for (std::string line; std::getline(text, line);) {
    line.erase(0, line.find_first_not_of(' '));
    if (line.starts_with(program)) {
      commands.push_back(line.substr(program.size()));
    }
  }
  return commands;
}

void check_all(const std::vector<std::string>& commands) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "out");
  std::filesystem::create_directory(folder.path() / "docs");
  std::filesystem::create_directory_symlink(RAYCAT_ASSETS, folder.path() / "assets");
  for (const std::string& command : commands) {
    const Outcome outcome =
        shell(fmt::format("cd '{}' && '{}' {}", folder.path().string(), RAYCAT_PROGRAM, command));
    INFO(command << "\n" << outcome.err);
    CHECK(outcome.code == 0);
    CHECK(outcome.err.empty());
  }
}

TEST_CASE("every raycat command of the README works as printed", "[app][readme]") {
  const auto commands = commands_of("README.md", "build/release/app/raycat ");
  REQUIRE(commands.size() >= 9);
  check_all(commands);
}

TEST_CASE("every raycat command of the other pages works as printed", "[app][readme]") {
  for (const char* const page : {"maps", "path-expressions", "scene-files", "convert", "measure",
                                 "materials", "antialiasing"}) {
    const auto commands = commands_of(fmt::format("docs/{}.md", page), "raycat ");
    CHECK(commands.size() >= 1);
    check_all(commands);
  }
}

}  // namespace
}  // namespace raycat
