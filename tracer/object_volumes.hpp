#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tracer/scene.hpp"

namespace raycat {

/// An object of a scene as a solid, or why it is none.
struct ObjectVolume {
  std::shared_ptr<const Solid> solid;  ///< null if the object encloses no finite volume
  std::string problem;                 ///< why it does not
  double open_area = 0.0;              ///< of an open mesh: the sum of its triangles
  Bounds open_bounds;                  ///< of an open mesh
};

/// One for each object of the scene, by `ObjectId`. The primitives of a mesh are one surface: it
/// is closed if they close a volume together. Refers to the solids of `scene`.
std::vector<ObjectVolume> object_volumes(const Scene& scene);

}  // namespace raycat
