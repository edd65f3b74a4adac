#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "geometry/shape.hpp"
#include "io/openscad_facets.hpp"
#include "io/openscad_parser.hpp"

namespace raycat::openscad {

class Parameters;

/// A shape moved by `offset`, in the frame of its node.
struct Primitive {
  Shape shape;
  glm::dvec3 offset{0.0};
};

/// Makes the solids of cube, sphere, cylinder and polyhedron nodes.
class PrimitiveMaker {
 public:
  /// `facets` is the rule where a node has none of its own.
  PrimitiveMaker(std::filesystem::path file, const FacetRule& facets,
                 std::vector<std::string>& warnings);

  /// Nothing if the solid has no volume, as OpenSCAD sees it. Throws `LoadError` for a parameter
  /// of the wrong type, a polyhedron that is not closed, or too many triangles in the file.
  std::optional<Primitive> make(const Node& node);

 private:
  std::optional<Primitive> cube(const Node& node);
  std::optional<Primitive> sphere(const Node& node);
  std::optional<Primitive> cylinder(const Node& node);
  std::optional<Primitive> polyhedron(const Node& node);

  std::uint32_t corners(const Parameters& parameters, double radius) const;
  void count_triangles(const Node& node, std::uint64_t triangles);
  Shape closed(const Node& node, Facets facets) const;

  std::filesystem::path file_;
  FacetRule facets_;
  std::vector<std::string>& warnings_;
  std::uint64_t triangles_ = 0;
};

}  // namespace raycat::openscad
