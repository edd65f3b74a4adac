
#include "io/load_scene.hpp"

#include <filesystem>
#include <string>

#include <catch2/catch.hpp>
#include <sys/stat.h>

#include "io/files/load_error.hpp"
#include "io/scene/closed_scene.hpp"
#include "tests/io/scene_text.hpp"

namespace raycat {
namespace {

TEST_CASE("a load error is one line of file, place and fault", "[io]") {
  CHECK(std::string(LoadError("a.csg", "line 3", "is\nbad").what()) == "a.csg: line 3: is bad");
  CHECK(std::string(LoadError("a.csg", "", "is bad").what()) == "a.csg: is bad");
}

TEST_CASE("what is no scene file is refused with one line", "[io]") {
  const std::filesystem::path folder = temporary_folder();
  CHECK_THROWS_WITH(load_scene(folder / "raycat-none.csg"),
                    (folder / "raycat-none.csg").string() + ": no such file");
  CHECK_THROWS_WITH(load_scene(folder), folder.string() + ": is a directory, not a file");
  CHECK_THROWS_WITH(load_scene("/dev/zero"), "/dev/zero: is not a regular file");
  CHECK(load_error("empty.csg", "") == "empty.csg: is empty");
  CHECK(load_error("scene.blend", "BLENDER") ==
        "scene.blend: unknown kind of scene file: the name must end in .gltf, .glb, .csg, .scad, "
        ".obj, .ply, .stl or .off");
  const std::filesystem::path fifo = folder / "fifo.csg";
  temporary_folder();
  REQUIRE(mkfifo(fifo.c_str(), 0600) == 0);
  CHECK_THROWS_WITH(load_scene(fifo), fifo.string() + ": is not a regular file");
  std::filesystem::remove_all(folder);
}

TEST_CASE("the kind of a file is told by its extension in any case", "[io]") {
  CHECK(load_text("a.CSG", "cube();").scene.surfaces.faces() == 6);
  CHECK(load_text("a.Obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").triangles == 1);
}

TEST_CASE("a scene without anything to see is not closed, and says so once", "[io][empty]") {
  const std::string text = GENERATE(
      as<std::string>(), R"({"asset":{"version":"2.0"},"nodes":[{}],"scenes":[{"nodes":[0]}]})",
      R"({"asset":{"version":"2.0"}})",
      R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[]}],"nodes":[{"mesh":0}],)"
      R"("scenes":[{"nodes":[0]}],"scene":0})");
  const SceneFile file = load_text("a.gltf", text);
  CHECK(file.warnings == std::vector<std::string>{"the scene holds nothing to see"});
  CHECK_FALSE(is_closed(file.scene));
}

}  // namespace
}  // namespace raycat
