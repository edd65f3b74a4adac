#include "io/files/scene_kind.hpp"

#include <fstream>

#include <catch2/catch.hpp>
#include <sys/stat.h>

#include "support/temporary_folder.hpp"

namespace raycat {
namespace {

TEST_CASE("a file's kind is told by its extension, in any case", "[io][files]") {
  CHECK(scene_kind("a.gltf") == SceneKind::gltf);
  CHECK(scene_kind("a.b.GLB") == SceneKind::gltf);
  CHECK(scene_kind("a.csg") == SceneKind::csg);
  CHECK(scene_kind("a.Scad") == SceneKind::scad);
  CHECK(scene_kind("a.obj") == SceneKind::obj);
  CHECK(scene_kind("a.ply") == SceneKind::ply);
  CHECK(scene_kind("a.STL") == SceneKind::stl);
  CHECK(scene_kind("a.off") == SceneKind::off);
  CHECK(scene_kind("a.png") == SceneKind::other);
  CHECK(scene_kind("gltf") == SceneKind::other);
}

TEST_CASE("a GLB is known by its first bytes, whatever it is called", "[io][files]") {
  const TemporaryFolder folder;
  std::ofstream(folder / "model.bin", std::ios::binary) << "glTF and so on";
  std::ofstream(folder / "model.stl", std::ios::binary) << "glTF and so on";
  std::ofstream(folder / "other.bin", std::ios::binary) << "glT";
  CHECK(scene_kind(folder / "model.bin") == SceneKind::gltf);
  CHECK(scene_kind(folder / "model.stl") == SceneKind::gltf);
  CHECK(scene_kind(folder / "other.bin") == SceneKind::other);
}

TEST_CASE("what is no regular file is not opened, which could wait for ever", "[io][files]") {
  const TemporaryFolder folder;
  REQUIRE(mkfifo((folder / "pipe.csg").c_str(), 0600) == 0);
  CHECK(scene_kind(folder / "pipe.csg") == SceneKind::csg);
  CHECK(scene_kind(folder.path()) == SceneKind::other);
}

}  // namespace
}  // namespace raycat
