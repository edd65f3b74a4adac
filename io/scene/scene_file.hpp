#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh_faces.hpp"
#include "io/files/load_budget.hpp"
#include "tracer/scene.hpp"

namespace raycat {

/// How round things of .csg files are traced: in OpenSCAD's facets, or as what they stand for.
enum class Facetting { openscad, smooth };

/// Are the back faces of opaque materials that glTF has single-sided seen?
enum class BackFaces { hide, show };

struct LoadOptions {
  FaceRule faces;               ///< how mesh triangles join into faces
  bool join_primitives = true;  ///< of a glTF mesh that continue each other (docs/scene-files.md)
  double exposure = 0.0;        ///< EV: glTF's lights count 2^exposure times
  Facetting facets = Facetting::openscad;
  BackFaces back_faces = BackFaces::hide;
  LoadLimits limits;           ///< of glTF files
  int threads = 1;             ///< that find faces; these do not depend on it
  std::string scene;           ///< of a glTF file, by name or number; the default scene if empty
  std::optional<double> time;  ///< seconds: glTF nodes in the pose of an animation, else at rest
  std::string animation;       ///< by name or number; the first if empty
  bool keep_going = false;     ///< warn of .csg nodes that cannot be made, and read the rest
};

/// A scene and what else its file tells.
struct SceneFile {
  Scene scene;
  glm::dvec3 up{0.0, 1.0, 0.0};  ///< +Z for .csg, .stl and .off; else +Y
  /// From where a scene without a camera is seen, a unit vector; if it is nothing, from the front
  /// right and above.
  std::optional<glm::dvec3> viewed_from;
  std::uint64_t triangles = 0;          ///< of meshes, each instance counted, hidden ones too
  std::uint64_t csg_nodes = 0;          ///< leaves and operations, of trees with an operation
  std::vector<std::string> extensions;  ///< that the file says it uses
  std::vector<std::string> warnings;    ///< one line each
  std::optional<LoadSeconds> seconds;   ///< that a glTF file took to read
};

}  // namespace raycat
