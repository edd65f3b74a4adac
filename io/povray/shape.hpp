#pragma once

#include <string>
#include <unordered_map>

#include "csg/tree.hpp"
#include "tracer/scene.hpp"

namespace raycat {

/// The shapes of a scene in POV-Ray's language. Meshes are declared once, however often they are
/// placed: `declarations()` must come before the shapes that refer to them.
class PovShapes {
 public:
  /// Everything is written `scale` times as large.
  explicit PovShapes(double scale) : scale_(scale) {}

  /// An object without its closing brace, so that a texture can follow.
  std::string open(const PlacedShape& shape);
  std::string open(const MeshInstance& instance);

  /// The mesh declarations that have not been taken yet.
  std::string take_declarations();

 private:
  // What a point of a shape is written as: factor * (point - centre).
  struct Form {
    glm::dvec3 centre{0.0};
    double factor = 1.0;
  };
  struct Declared {
    std::string name;
    Form form;
  };

  std::string open(const Declared& mesh, const Affine& transform) const;
  std::string place(const Affine& transform, const Form& form) const;
  const Declared& declare(const TriangleMesh& mesh, const std::vector<glm::vec3>& normals,
                          bool closed);

  double scale_;
  std::unordered_map<const TriangleMesh*, Declared> meshes_;
  std::string declarations_;
};

}  // namespace raycat
