#include "io/files/output_file.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>

#include "support/temporary_folder.hpp"

namespace raycat {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST_CASE("a file is written whole, in place of what was there", "[io][output]") {
  const TemporaryFolder folder;
  write_file(folder / "a", std::string("first"));
  CHECK(content(folder / "a") == "first");
  write_file(folder / "a", std::string("2nd"));
  CHECK(content(folder / "a") == "2nd");
  CHECK(folder.files() == 1);
}

TEST_CASE("a link is kept and what it names is replaced", "[io][output]") {
  const TemporaryFolder folder;
  write_file(folder / "a", std::string("old"));
  fs::create_symlink(folder / "a", folder / "link");
  write_file(folder / "link", std::string("new"));
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(content(folder / "a") == "new");
}

TEST_CASE("what cannot be written leaves nothing and says why", "[io][output]") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(write_file(folder / "none/a", std::string("x")),
                    (folder / "none/a") + ": cannot write: No such file or directory");
  CHECK_THROWS_WITH(write_file("/dev/full", std::string("x")),
                    "/dev/full: cannot write: No space left on device");
  fs::create_directory(folder / "dir");
  CHECK_THROWS_WITH(write_file(folder / "dir", std::string("x")),
                    (folder / "dir") + ": cannot write: Is a directory");
  CHECK(folder.files() == 1);
}

}  // namespace
}  // namespace raycat
