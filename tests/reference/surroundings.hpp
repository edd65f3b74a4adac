#pragma once

#include <array>
#include <optional>
#include <vector>

#include "reference/line.hpp"
#include "reference/solid_passages.hpp"
#include "tracer/scene.hpp"

namespace raycat::reference {

/// A triangle in the world.
struct Facet {
  std::array<Vec, 3> corners;
  Vec normal{0.0L};                 ///< unit, out of the object
  std::array<Vec, 3> mesh_normals;  ///< of the corners, in the mesh's frame, if it has normals
  const MeshInstance* instance = nullptr;
  SurfaceId surface{};

  bool smooth() const { return !instance->mesh->normals.empty(); }
};

/// A passage of a line through a surface of the scene.
struct Meeting {
  Real t = 0.0L;
  Vec normal{0.0L};  ///< unit, out of the object
  bool entering = true;
  SurfaceId surface{};
  ObjectId object{};
  const Material* material = nullptr;
  const Facet* facet = nullptr;  ///< of a mesh
  Vec weights{0.0L};             ///< barycentric, of the facet's corners
};

/// Does light pass the surface?
inline bool transmits(const Material& material) { return material.transmission != glm::vec3(0.0f); }

/// A line from where it starts: from the eye, or from a surface that it leaves.
struct Way {
  Line line;  ///< of unit direction
  std::optional<Meeting> from;
};

/// All surfaces of a scene, each tried for every line.
class Surroundings {
 public:
  /// Keeps a reference to `scene`.
  explicit Surroundings(const Scene& scene);

  /// What lies on the way, in the order in which it is met. Surfaces of several objects, or
  /// primitives, that lie in one surface are met as if each were moved into its own object by an
  /// infinitely small distance that grows with its rank (docs/design.md, Coincident surfaces).
  std::vector<Meeting> ahead(const Way& way) const;

  /// Do two meetings on a line of this direction lie in one surface?
  bool in_one_place(const Vec& direction, const Meeting& a, const Meeting& b) const;

  /// The normal that a meeting is shaded by, unit, out of the object: of a mesh with normals
  /// interpolated in its own frame, unless the outcome is no normal of the triangle's side.
  static Vec shading_normal(const Meeting& meeting);

  /// Where shadow rays from a meeting at `point` start: on a mesh with normals the mean of the
  /// point's feet on the tangent planes of the corners that it lies below. `side` is 1 where the
  /// surface is seen from outside, else -1.
  static Vec lifted(const Meeting& meeting, const Vec& point, Real side);

  /// A length that is nothing in the scene, and more than what rounding makes of nothing.
  Real hair() const { return 1e-13L * size_; }

  const Scene& scene() const noexcept { return scene_; }

 private:
  void add_solids(const Line& line, std::vector<Meeting>& out) const;
  void add_meshes(const Line& line, std::vector<Meeting>& out) const;

  const Scene& scene_;
  std::vector<SolidPassages> solids_;
  std::vector<Facet> facets_;
  Real size_ = 1.0L;  // of the scene: half its diagonal
};

}  // namespace raycat::reference
