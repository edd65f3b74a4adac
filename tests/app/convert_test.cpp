#include <algorithm>
#include <random>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "app/program.hpp"

namespace raycat {
namespace {

using Json = nlohmann::json;

constexpr const char* plate = R"csg(
difference() {
  cube(size = [30, 20, 4], center = true);
  cylinder($fn = 40, h = 8, r1 = 5, r2 = 5, center = true);
  multmatrix([[1, 0, 0, 10], [0, 1, 0, 0], [0, 0, 1, 2], [0, 0, 0, 1]]) {
    sphere($fn = 20, r = 3);
  }
}
)csg";

bool one_line(const std::string& text) {
  return text.starts_with("raycat: ") && text.ends_with('\n') &&
         std::ranges::count(text, '\n') == 1;
}

TEST_CASE("the same rays probe the same on a scene and on what it was converted to",
          "[app][convert]") {
  const TemporaryFolder folder;
  const std::string from = folder.write("plate.csg", plate);
  const std::string to = folder / "plate.glb";
  const Outcome done = raycat(fmt::format("convert '{}' -o '{}' --json", from, to));
  INFO(done.err);
  REQUIRE(done.code == 0);
  CHECK(done.err.empty());
  const Json figures = Json::parse(done.out);
  CHECK(figures["out"] == to);
  CHECK(figures["objects"] == 1);
  CHECK(figures["triangles"] > 200);

  std::string rays;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    rays += fmt::format("{} {} 20 {} {} -1\n", 15 * unit(random), 10 * unit(random),
                        0.3 * unit(random), 0.3 * unit(random));
  }
  const std::string file = folder.write("rays.txt", rays);
  const auto probe = [&](const std::string& scene) {
    const Outcome outcome = raycat(fmt::format("probe '{}' --rays '{}' --json", scene, file));
    CHECK(outcome.code == 0);
    return outcome.out;
  };
  std::istringstream first(probe(from));
  std::istringstream second(probe(to));
  int crossings = 0;
  for (int i = 0; i < 500; ++i) {
    std::string a;
    std::string b;
    REQUIRE(std::getline(first, a));
    REQUIRE(std::getline(second, b));
    const Json in_first = Json::parse(a)["crossings"];
    const Json in_second = Json::parse(b)["crossings"];
    REQUIRE(in_first.size() == in_second.size());
    for (std::size_t k = 0; k < in_first.size(); ++k, ++crossings) {
      for (const char* const key : {"object", "primitive", "face", "id", "entering"}) {
        CHECK(in_first[k][key] == in_second[k][key]);
      }
      CHECK(in_first[k]["t"].get<double>() == Approx(in_second[k]["t"].get<double>()).margin(1e-4));
    }
  }
  CHECK(crossings > 500);
}

TEST_CASE("a finer chord makes more triangles", "[app][convert]") {
  const TemporaryFolder folder;
  const auto triangles = [&](const std::string& chord) {
    const Outcome outcome = raycat(fmt::format("convert {} -o '{}' --json --quiet {}",
                                               scene("fig10"), folder / "out.stl", chord));
    REQUIRE(outcome.code == 0);
    return Json::parse(outcome.out)["triangles"].get<int>();
  };
  CHECK(triangles("--chord 0.01") < triangles(""));
  CHECK(triangles("") == triangles("--chord 0.001"));
  CHECK(triangles("--chord 0.0002") > triangles(""));
}

TEST_CASE("every format is written under its name, and no other file is left", "[app][convert]") {
  const TemporaryFolder folder;
  const std::string from = folder.write("plate.csg", plate);
  for (const std::string name : {"a.glb", "b.stl", "c.obj", "d.ply", "e.PLY"}) {
    CHECK(raycat(fmt::format("convert '{}' -o '{}'", from, folder / name)).code == 0);
    CHECK(raycat(fmt::format("info '{}' --json", folder / name)).code == 0);
  }
  CHECK(folder.files() == 6);
}

struct Case {
  const char* arguments;
  const char* says;
};

TEST_CASE("what cannot be converted is one line and exit code 2", "[app][convert][bad]") {
  const TemporaryFolder folder;
  folder.write("plate.csg", plate);
  folder.write("ground.gltf", R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
      "nodes":[{"name":"ground","extras":{"shape":{"type":"plane"}}}]})");
  folder.write("nothing.csg", "difference() { cube(size = [1, 1, 1]); cube(size = [1, 1, 1]); }");
  const auto [arguments, says] = GENERATE(
      Case{"plate.csg -o out.xyz",
           "unknown kind of file to convert to: the name must end in .glb, .obj, .ply, .pov, .stl"},
      Case{"plate.csg -o out", "unknown kind of file"},
      Case{"plate.csg -o glb", "unknown kind of file"}, Case{"plate.csg", "--out is required"},
      Case{"ground.gltf -o out.stl", "holds no surface that can be made of triangles"},
      Case{"nothing.csg -o out.glb", "holds no surface that can be made of triangles"},
      Case{"plate.csg -o out.glb --chord 0", "'0' is not a number from 1e-05 to 0.5"},
      Case{"plate.csg -o out.glb --chord nan", "'nan' is not a number from 1e-05 to 0.5"},
      Case{"plate.csg -o out.glb --simplify 0", "'0' is not a number from 1e-09 to 0.5"},
      Case{"plate.csg -o out.pov --simplify 0.1",
           "--simplify is of triangles, which a .pov file has none of"},
      Case{"plate.csg -o out.pov --chord 0.1",
           "--chord is of triangles, which a .pov file has none of"},
      Case{"missing.csg -o out.glb", "missing.csg: "});
  const Outcome outcome = shell(
      fmt::format("cd '{}' && '{}' convert {}", folder.path().string(), RAYCAT_PROGRAM, arguments));
  INFO(outcome.err);
  CHECK(outcome.code == 2);
  CHECK(one_line(outcome.err));
  CHECK(outcome.err.find(says) != std::string::npos);
  CHECK(folder.files() == 3);
}

TEST_CASE("a conversion does not overwrite its scene", "[app][convert][bad]") {
  const TemporaryFolder folder;
  folder.write("plate.csg", plate);
  const std::string out = folder / "plate.glb";
  REQUIRE(raycat(fmt::format("convert '{}' -o '{}'", folder / "plate.csg", out)).code == 0);
  const std::string before = read_file(out);
  const Outcome outcome = raycat(fmt::format("convert '{}' -o '{}'", out, out));
  CHECK(outcome.code == 2);
  CHECK(outcome.err.find("the output would overwrite the scene") != std::string::npos);
  CHECK((read_file(out) == before));
  // A folder that is not there is found out before the work.
  CHECK(raycat(fmt::format("convert '{}' -o '{}'", out, folder / "no" + "/x.stl")).code == 1);
}

TEST_CASE("the commands of the page on converting work as printed", "[app][convert]") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "out");
  std::filesystem::create_directory_symlink(RAYCAT_ASSETS, folder.path() / "assets");
  std::istringstream page(read_file(std::string(RAYCAT_SOURCE) + "/docs/convert.md"));
  int commands = 0;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("    raycat ")) {
      const Outcome outcome = shell(fmt::format("cd '{}' && '{}' {}", folder.path().string(),
                                                RAYCAT_PROGRAM, line.substr(11)));
      INFO(line << "\n" << outcome.err);
      CHECK(outcome.code == 0);
      ++commands;
    }
  }
  CHECK(commands >= 2);
}

}  // namespace
}  // namespace raycat
