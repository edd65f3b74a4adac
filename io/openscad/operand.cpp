#include "io/openscad/operand.hpp"

#include <algorithm>

#include "geometry/tessellate.hpp"
#include "modelling/evaluate.hpp"

namespace raycat::openscad {

namespace {

CsgTree tree_of(const Items& from, std::uint32_t at) {
  CsgTree tree;
  std::uint32_t face = 0;
  add_tree(from, at, tree, [&](std::uint32_t leaf) {
    const PlacedShape& shape = from.shapes[*from.items[leaf].solid];
    const SurfaceId first{face};
    face += shape.face_count();
    return CsgLeaf{.shape = shape, .first_face = first};
  });
  return tree;
}

// Operands are boxes and meshes, so that no chord error comes in.
TriangleMesh mesh_of(const PlacedShape& shape) {
  TriangleMesh mesh = tessellate(shape.shape(), 1.0);
  for (glm::dvec3& position : mesh.positions) {
    position = shape.transform().point(position);
  }
  if (shape.transform().mirrored()) {
    for (glm::uvec3& triangle : mesh.triangles) {
      std::swap(triangle.y, triangle.z);
    }
  }
  return mesh;
}

void append(std::vector<glm::dvec3>& to, const std::vector<glm::dvec3>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

}  // namespace

TriangleMesh operand_mesh(const Items& from, std::uint32_t at) {
  CsgTree tree = tree_of(from, at);
  return tree.leaves().size() == 1 ? mesh_of(tree.leaves().front().shape) : evaluate(tree, {}).mesh;
}

std::vector<glm::dvec3> operand_points(const Items& from, std::uint32_t at) {
  std::vector<glm::dvec3> points;
  for (const std::uint32_t end = from.nodes[at].end; at < end;) {
    const Item& item = from.items[at];
    if (item.usable && !item.solid && item.kind != Kind::intersect && item.kind != Kind::subtract) {
      ++at;  // a union: its operands' points
      continue;
    }
    if (item.usable) {
      append(points, operand_mesh(from, at).positions);
    }
    at = from.nodes[at].end;
  }
  return points;
}

}  // namespace raycat::openscad
