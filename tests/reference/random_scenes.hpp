#pragma once

#include "tracer/scene.hpp"

namespace raycat::reference {

/// A scene of a random number's making, with `Scene::cameras` of one camera: shapes of all kinds,
/// turned, stretched, sheared and mirrored, lone or under set operations, and meshes, some one in
/// another, of stone, mirrors and glass; lights of all kinds. No two objects share a surface;
/// operands of set operations may.
Scene random_scene(unsigned seed);

}  // namespace raycat::reference
