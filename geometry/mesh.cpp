#include "geometry/mesh.hpp"

#include <cassert>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>

#include "geometry/triangle_index.hpp"
#include "geometry/watertight.hpp"

namespace raycat {
namespace {

// Appends a crossing wherever the winding number rises above zero or falls back to it.
// Passages closer than the tolerance are in an order that only rounding has decided, so they
// count as one.
void emit_boundary(const TriangleIndex& index, const TriangleIndex::Passages& passed,
                   const TriangleMesh& mesh, Crossings& out) {
  const std::vector<TriangleIndex::Passage>& passages = passed.list;
  int winding = 0;
  for (std::size_t begin = 0, end = 0; begin < passages.size(); begin = end) {
    int change = 0;
    for (; end < passages.size() && passages[end].t - passages[begin].t <= passed.tolerance;
         ++end) {
      change += passages[end].turn;
    }
    const bool was_inside = winding > 0;
    winding += change;
    const bool is_inside = winding > 0;
    if (was_inside == is_inside) {
      continue;
    }
    const int turn = is_inside ? 1 : -1;
    const TriangleIndex::Passage* widest = nullptr;
    for (std::size_t i = begin; i < end; ++i) {
      if (passages[i].turn == turn && (widest == nullptr || passages[i].area > widest->area)) {
        widest = &passages[i];
      }
    }
    // The group's first t, since only those are sure to stay apart when shifted.
    out.push_back({.t = passed.t_shift + passages[begin].t,
                   .normal = index.outward_normal(*widest, passed.near.direction),
                   .face = mesh.faces[widest->triangle],
                   .piece = widest->triangle,
                   .entering = is_inside});
  }
  assert(winding == 0);
}

}  // namespace

Bounds bounds(const TriangleMesh& mesh) {
  Bounds box;
  for (const glm::uvec3& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      box.include(mesh.positions[triangle[k]]);
    }
  }
  return box;
}

double signed_volume(const TriangleMesh& mesh) {
  const glm::dvec3 centre = bounds(mesh).center();
  double sum = 0.0;
  for (const glm::uvec3& triangle : mesh.triangles) {
    const glm::dvec3 a = mesh.positions[triangle.x] - centre;
    const glm::dvec3 b = mesh.positions[triangle.y] - centre;
    const glm::dvec3 c = mesh.positions[triangle.z] - centre;
    sum += glm::dot(a, glm::cross(b, c));
  }
  return sum / 6.0;
}

ClosedMesh::ClosedMesh(TriangleMesh mesh)
    : mesh_(watertight(std::move(mesh))), index_(std::make_unique<TriangleIndex>(mesh_)) {}

ClosedMesh::~ClosedMesh() = default;

const Bounds& ClosedMesh::bounds() const noexcept { return index_->bounds(); }

void ClosedMesh::cross(const Ray& ray, Crossings& out) const {
  thread_local TriangleIndex::Passages passages;
  index_->pass(ray, passages);
  emit_boundary(*index_, passages, mesh_, out);
}

}  // namespace raycat
