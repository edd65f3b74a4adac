#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/program.hpp"

namespace raycat {
namespace {

bool one_line(const std::string& text) {
  return text.starts_with("raycat: ") && text.ends_with('\n') &&
         std::ranges::count(text, '\n') == 1;
}

// A minimal scene of raycat's with one node.
std::string gltf(const std::string& nodes) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + nodes +
         "]}";
}

struct Case {
  const char* name;
  const char* text;
  const char* says;
};

TEST_CASE("a scene that cannot be read is one line and exit code 2", "[app][bad]") {
  const TemporaryFolder folder;
  const auto [name, text, says] = GENERATE(
      Case{"empty.gltf", "", "empty"},
      Case{"cut.gltf", R"({"asset":{"version":"2.0"},"nodes":[{"na)", "cut.gltf: "},
      Case{"scene.xyz", "what", "xyz"},
      Case{"noise.glb", "glTF\x02 and then nothing", "noise.glb: "},
      Case{"key.gltf", R"({"name":"ball","extras":{"shape":{"type":"sphere","raduis":1}}})",
           "unknown key 'raduis'"},
      Case{"beside.gltf", R"({"extras":{"shape":{"type":"sphere"},"matrial":0}})",
           "unknown key 'matrial'"},
      Case{"huge.gltf", R"({"extras":{"shape":{"type":"sphere","radius":1e200}}})", "1e18"},
      Case{"type.gltf", R"({"extras":{"shape":{"type":"blob"}}})", "blob"},
      Case{"childless.gltf", R"({"name":"cut","extras":{"csg":"difference"}})", "'cut'"},
      Case{"size.gltf", R"({"extras":{"shape":{"type":"sphere","radius":-1}}})",
           "radius must be a finite number above 0, but is -1"},
      Case{"wrong.csg", "cube(size = [1, 1, 1);", "line 1"});
  const bool bare =
      std::string(text).starts_with("{\"name") || std::string(text).starts_with("{\"extras");
  const std::string file = folder.write(name, bare ? gltf(text) : text);
  const std::string out = folder / "out.png";
  for (const std::string& command :
       {fmt::format("render '{}' -o '{}'", file, out), fmt::format("info '{}'", file)}) {
    const Outcome outcome = raycat(command);
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(one_line(outcome.err));
    CHECK(outcome.err.find(says) != std::string::npos);
    CHECK(outcome.out.empty());
    CHECK(folder.files() == 1);
  }
}

TEST_CASE("a scene that is no file is one line and exit code 2", "[app][bad]") {
  const TemporaryFolder folder;
  const Outcome missing = raycat(fmt::format("info '{}'", folder / "none.gltf"));
  CHECK(missing.code == 2);
  CHECK(one_line(missing.err));
  CHECK(missing.err.find("none.gltf") != std::string::npos);
  const Outcome directory = raycat(fmt::format("info '{}'", folder.path().string()));
  CHECK(directory.code == 2);
  CHECK(one_line(directory.err));
  CHECK(directory.err.find("directory") != std::string::npos);
}

TEST_CASE("an operand that is an open mesh is named", "[app][bad]") {
  const TemporaryFolder folder;
  // One triangle is no volume.
  const std::string file = folder.write("open.gltf", R"({"asset":{"version":"2.0"},
    "scene":0,"scenes":[{"nodes":[0]}],
    "nodes":[{"name":"cut","extras":{"csg":"difference"},"children":[1,2]},
             {"name":"block","extras":{"shape":{"type":"box"}}},
             {"name":"sheet","mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
                  "min":[0,0,0],"max":[1,1,0]}],
    "bufferViews":[{"buffer":0,"byteLength":36}],
    "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
  const Outcome outcome = raycat(fmt::format("info '{}'", file));
  INFO(outcome.err);
  CHECK(outcome.code == 2);
  CHECK(one_line(outcome.err));
  CHECK(outcome.err.find("'sheet'") != std::string::npos);
  CHECK(outcome.err.find("open") != std::string::npos);
}

TEST_CASE("bad usage is one line and exit code 2", "[app][bad]") {
  const TemporaryFolder folder;
  const std::string fig1 = scene("fig1");
  const std::string out = fmt::format(" -o '{}'", folder / "out.png");
  const std::vector<std::string> all{
      std::string(),
      std::string("paint"),
      "render " + fig1,
      "render" + out,
      "render " + fig1 + out + " --size 0x512",
      "render " + fig1 + out + " --size 512",
      "render " + fig1 + out + " --size 512x-1",
      "render " + fig1 + out + " --size 1000000x1000000",
      "render " + fig1 + out + " --size 65536x65536",
      "render " + fig1 + out + " --levels 0",
      "render " + fig1 + out + " --levels 65",
      "render " + fig1 + out + " --method magic",
      "render " + fig1 + out + " --ids atom",
      "render " + fig1 + out + " --threads 0",
      "render " + fig1 + out + " --camera nobody",
      "render " + fig1 + out + " --view 1,2,3",
      "render " + fig1 + out + " --view 1,2,3,1,2,3",
      "render " + fig1 + out + " --min-weight 2",
      "render " + fig1 + out + " --aa best",
      "render " + fig1 + out + " --quality 0.1",
      "render " + fig1 + " --aa whitted --coverage '" + (folder / "c.exr") + "'",
      "render " + fig1 + " --aa adaptive --coverage '" + (folder / "c.png") + "'",
      "render " + fig1 + out + " --aa adaptive --samples 4",
      "render " + fig1 + out + " --aa adaptive --quality 0",
      "render " + fig1 + out + " --aa whitted --samples 3",
      "render " + fig1 + out + " --aa uniform --threshold 0.1",
      "render " + fig1 + out + " --aa whitted --budget 2",
      "render " + fig1 + out + " --aa adaptive --budget 2 --quality 0.1",
      "render " + fig1 + out + " --aa adaptive --budget 0.5",
      "render " + fig1 + out + " --aa adaptive --budget nan",
      "render " + fig1 + out + " --aa category --filter tent",
      "render " + fig1 + out + " --aa uniform --filter sinc",
      "render " + fig1 + " --alpha --edges '" + (folder / "e.png") + "'",
      "render " + fig1 + " --alpha -o '" + (folder / "a.ppm") + "'",
      "render " + fig1 + out + " --paths D",
      "render " + fig1 + out + " --paths ''",
      "render " + fig1 + out + " --paths \"C<R.'nobody'>\"",
      "render " + fig1 + out + " --textures never",
      "render " + fig1 + out + " --subpixel 7",
      "render " + fig1 + out + " --subpixel 6 --size 2000x2000",
      "render " + fig1 + out + " --view-as heat",
      "render " + fig1 + out + " --view-as depth=",
      "render " + fig1 + out + " --subpixel 2",
      "render " + fig1 + out + " --method none --paths C",
      "render " + fig1 + out + " --view-as depth --view-as nodes",
      "render " + fig1 + out + " --view-as depth --method none",
      "render " + fig1 + out + " --view-as depth --method string",
      "render " + fig1 + " --view-as depth --json",
      "render " + fig1 + " --view-as depth='" + (folder / "depth.txt") + "'",
      "render " + fig1 + out + " --edge-classes '" + (folder / "classes.exr") + "'",
      "render " + fig1 + out + " --method primes --edge-classes '" + (folder / "c.png") + "'",
      "compare " + fig1 + " --repetitions 4",
      "compare " + fig1 + " --paths 'C('",
      "render " + fig1 + out + " --ids 2",
      "render " + fig1 + out + " --lights 2",
      "render " + fig1 + out + " --method 1",
      "render " + fig1 + out + " --min-weight nan",
      "info " + fig1 + " --crease nan",
      "info " + fig1 + " --exposure inf",
      "render " + fig1 + out + " --edges '" + (folder / "out.png") + "'",
      "render " + fig1 + out + " --stats '" + (folder / "./out.png") + "'",
      "render " + fig1 + " --stats " + fig1,
      "probe " + fig1 + " --rays /tmp",
      "render " + fig1 + fmt::format(" -o '{}'", folder / "out.gif"),
      "render " + fig1 + out + " --method none --lines '" + (folder / "lines.png") + "'",
      "probe " + fig1,
      "probe " + fig1 + " --pixel 512,0",
      "probe " + fig1 + " --pixel 1x2",
      "probe " + fig1 + " --rays '" + (folder / "none") + "'"};
  for (const std::string& arguments : all) {
    const Outcome outcome = raycat(arguments);
    INFO(arguments << "\n" << outcome.err);
    CHECK(outcome.code == 2);
    CHECK(one_line(outcome.err));
    CHECK(outcome.out.empty());
    CHECK(folder.files() == 0);
  }
}

TEST_CASE("rays that cannot be read are named by their line", "[app][bad]") {
  const TemporaryFolder folder;
  const std::string rays = folder.write("rays", "0 0 5 0 0 -1\n0 0 5 0 0 0\n");
  const Outcome outcome = raycat(fmt::format("probe {} --rays '{}' --json", scene("fig1"), rays));
  CHECK(outcome.code == 2);
  CHECK(one_line(outcome.err));
  CHECK(outcome.err.find("line 2") != std::string::npos);
}

TEST_CASE("an output that cannot be written is one line and exit code 1", "[app][bad]") {
  const TemporaryFolder folder;
  const std::string quick = "render " + scene("fig1") + " --size 16x16 ";
  std::filesystem::create_symlink("/dev/full", folder.path() / "full.png");
  const std::vector<std::string> all{quick + "-o '" + (folder / "no/such/folder/out.png") + "'",
                                     quick + "-o /dev/full",
                                     quick + "-o '" + (folder / "full.png") + "'",
                                     quick + "--json > /dev/full",
                                     quick + "--stats /dev/full",
                                     std::string("info ") + scene("fig1") + " --json > /dev/full"};
  for (const std::string& arguments : all) {
    const Outcome outcome = raycat(arguments);
    INFO(arguments << "\n" << outcome.err);
    CHECK(outcome.code == 1);
    CHECK(one_line(outcome.err));
    CHECK(folder.files() == 1);  // the link
  }
}

TEST_CASE("an interrupt ends a render with one line and no file", "[app][bad]") {
  const TemporaryFolder folder;
  // SIGINT goes out half a second after the program has said that it handles it.
  const Outcome outcome = shell(
      fmt::format("'{}' render {} -o '{}' --size 4000x4000 & pid=$!; for i in $(seq 600); do "
                  "grep -q 'SigCgt:.*[2367abef]$' /proc/$pid/status && break; sleep 0.1; done; "
                  "sleep 0.5; kill -INT $pid; wait $pid",
                  RAYCAT_PROGRAM, scene("fig9"), folder / "out.png"));
  CHECK(outcome.code == 1);
  CHECK(outcome.err == "raycat: interrupted\n");
  CHECK(folder.files() == 0);
}

}  // namespace
}  // namespace raycat
