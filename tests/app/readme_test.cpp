#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/program.hpp"

namespace raycat {
namespace {

// The lines of the README's code that run raycat, as a reader would type them.
std::vector<std::string> readme_commands() {
  const std::string program = "build/release/app/raycat ";
  std::istringstream readme(read_file(std::filesystem::path(RAYCAT_SOURCE) / "README.md"));
  std::vector<std::string> commands;
  for (std::string line; std::getline(readme, line);) {
    line.erase(0, line.find_first_not_of(' '));
    if (line.starts_with(program)) {
      commands.push_back(line.substr(program.size()));
    }
  }
  return commands;
}

TEST_CASE("every raycat command of the README works as printed", "[app][readme]") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "out");
  std::filesystem::create_directory(folder.path() / "docs");
  std::filesystem::create_directory_symlink(RAYCAT_ASSETS, folder.path() / "assets");
  const auto commands = readme_commands();
  REQUIRE(commands.size() >= 5);
  for (const std::string& command : commands) {
    const Outcome outcome =
        shell(fmt::format("cd '{}' && '{}' {}", folder.path().string(), RAYCAT_PROGRAM, command));
    INFO(command << "\n" << outcome.err);
    CHECK(outcome.code == 0);
    CHECK(outcome.err.empty());
  }
}

}  // namespace
}  // namespace raycat
