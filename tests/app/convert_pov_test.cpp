#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "app/program.hpp"

namespace raycat {
namespace {

TEST_CASE("convert writes a scene for POV-Ray with the view that is asked for", "[app][convert]") {
  const TemporaryFolder folder;
  const std::string path = folder / "a.pov";
  const Outcome outcome = raycat(
      fmt::format("convert {} -o '{}' --size 300x200 --json --view 0,0,5,0,0,0,90 --levels 3",
                  scene("fig10"), path));
  CHECK(outcome.code == 0);
  CHECK(nlohmann::json::parse(outcome.out) ==
        nlohmann::json{{"out", path}, {"objects", 4}, {"lights", 2}});
  const std::string text = read_file(path);
  CHECK(text.starts_with("// Render with: povray +IFILE.pov +W300 +H200 -A -J File_Gamma=sRGB\n"));
  CHECK(text.find("max_trace_level 3") != std::string::npos);
  CHECK(text.find("location <0, 0, 5>\n  direction <0, 0, -1>\n") != std::string::npos);
  CHECK(text.find("\nintersection {\nbox { <-1, -1, -1>, <1, 1, 1> matrix <") != std::string::npos);
}

TEST_CASE("a place or kind that convert cannot write is one line", "[app][convert]") {
  const TemporaryFolder folder;
  const std::string ball =
      folder.write("ball.pov",  // a scene file's kind is told by its content, too
                   R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
                   R"("nodes":[{"extras":{"shape":{"type":"sphere"}}}]})");
  const auto fails = [&](const std::string& arguments, int code, const std::string& says) {
    const Outcome outcome = raycat("convert " + arguments);
    INFO(outcome.err);
    CHECK(outcome.code == code);
    CHECK(outcome.err.starts_with("raycat: "));
    CHECK(outcome.err.find(says) != std::string::npos);
    CHECK(outcome.out.empty());
    CHECK(folder.files() == 1);
  };
  fails(scene("fig10"), 2, "--out is required");
  fails(fmt::format("{} -o '{}'", scene("fig10"), folder / "a.xyz"), 2,
        "a.xyz: unknown kind of file to convert to: the name must end in");
  fails(fmt::format("'{}' -o '{}'", ball, ball), 2, "the output would overwrite the scene");
  fails(fmt::format("{} -o '{}'", scene("fig10"), folder / "none/a.pov"), 1, "cannot write");
  fails(fmt::format("{} -o '{}' --camera no", scene("fig10"), folder / "a.pov"), 2,
        "no such camera");
}

}  // namespace
}  // namespace raycat
