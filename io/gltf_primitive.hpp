#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "geometry/mesh_faces.hpp"
#include "io/gltf_document.hpp"
#include "io/gltf_features.hpp"
#include "io/gltf_material.hpp"
#include "tracer/scene.hpp"

namespace raycat {

/// Reads the triangles of one primitive of a mesh, whose material is `material` or null. Its faces
/// are its features, as `names` tells them if it is not null; without features they are found by
/// the rule. Takes what it holds from the budget. Null if the primitive is of points or
/// lines, or has no positions; then `document` has a warning more. Triangles with a corner that is
/// not finite are dropped with a warning. Throws `LoadError`.
std::shared_ptr<const SurfaceMesh> read_primitive(GltfDocument& document, std::size_t mesh,
                                                  std::size_t primitive,
                                                  const GltfMaterial* material,
                                                  const FaceRule& faces, const FeatureNames* names,
                                                  LoadBudget& budget);

}  // namespace raycat
