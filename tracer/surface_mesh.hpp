#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "geometry/mesh.hpp"
#include "tracer/texel_grid.hpp"
#include "tracer/texture_place.hpp"

namespace raycat {

/// Faces of a mesh that an image tells, finer than its triangles: EXT_mesh_features in a texture.
/// A point is of the face of the nearest texel, since numbers of faces have nothing between them.
struct FeatureMap {
  TexelGrid grid;
  std::vector<std::uint32_t> faces;  ///< one a texel
  TexturePlace place;
};

/// Triangles with what shading needs. Attributes are per vertex, or absent.
struct SurfaceMesh {
  TriangleMesh triangles;
  std::vector<glm::vec3> normals;
  std::vector<std::vector<glm::vec2>> texture_coordinates;  ///< sets of them; any may be empty
  std::vector<glm::vec4> colours;                           ///< linear
  /// Triangles on the same three points, which are one surface: as `coincident_twins` has them
  /// (geometry/coincident_twins.hpp), so empty if there are none.
  std::vector<std::uint32_t> twins;
  /// Where there is one, it tells the face of each point, and `triangles.faces` only those of the
  /// triangles' middles.
  std::shared_ptr<const FeatureMap> features;
};

/// A point on a mesh.
struct MeshPoint {
  const SurfaceMesh& mesh;
  std::uint32_t triangle = 0;
  glm::dvec2 barycentric{0.0};  ///< of the triangle's second and third corner

  /// Where it is on an image; nothing if the mesh does not have such coordinates.
  std::optional<glm::dvec2> on(const TexturePlace& place) const;

  /// Of the vertices; white if they have none.
  glm::vec4 colour() const;

  std::uint32_t face() const {
    return mesh.features ? mapped_face() : mesh.triangles.faces[triangle];
  }

 private:
  std::uint32_t mapped_face() const;
};

}  // namespace raycat
