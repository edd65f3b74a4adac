// Set operations of meshes and shapes, evaluated by rays and by CGAL's exact corefinement.

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "csg/solid.hpp"
#include "geometry/mesh.hpp"
#include "tests/csg/random_models.hpp"

namespace raycat {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;

// A ball of 8 * rings triangles or so, dented at random, so that it is closed but not convex.
TriangleMesh dented_ball(Random& random, const glm::dvec3& centre, std::uint32_t around = 10,
                         std::uint32_t rings = 6) {
  TriangleMesh mesh;
  const auto add = [&](double polar, double turn) {
    const double radius = uniform(random, 0.6, 1.0);
    mesh.positions.push_back(centre + radius * glm::dvec3(std::sin(polar) * std::cos(turn),
                                                          std::sin(polar) * std::sin(turn),
                                                          std::cos(polar)));
  };
  add(0.0, 0.0);
  for (std::uint32_t ring = 1; ring <= rings; ++ring) {
    for (std::uint32_t k = 0; k < around; ++k) {
      add(3.141592653589793 * ring / (rings + 1), 6.283185307179586 * k / around);
    }
  }
  add(3.141592653589793, 0.0);
  const auto at = [&](std::uint32_t ring, std::uint32_t k) {
    return 1 + (ring - 1) * around + k % around;
  };
  const std::uint32_t south = 1 + rings * around;
  for (std::uint32_t k = 0; k < around; ++k) {
    mesh.triangles.emplace_back(0, at(1, k), at(1, k + 1));
    mesh.triangles.emplace_back(south, at(rings, k + 1), at(rings, k));
    for (std::uint32_t ring = 1; ring < rings; ++ring) {
      mesh.triangles.emplace_back(at(ring, k), at(ring + 1, k), at(ring + 1, k + 1));
      mesh.triangles.emplace_back(at(ring, k), at(ring + 1, k + 1), at(ring, k + 1));
    }
  }
  mesh.faces.assign(mesh.triangles.size(), 0);
  mesh.face_count = 1;
  return mesh;
}

CgalMesh to_cgal(const TriangleMesh& mesh) {
  CgalMesh out;
  std::vector<CgalMesh::Vertex_index> vertices;
  for (const glm::dvec3& p : mesh.positions) {
    vertices.push_back(out.add_vertex(Kernel::Point_3(p.x, p.y, p.z)));
  }
  for (const glm::uvec3& t : mesh.triangles) {
    out.add_face(vertices[t.x], vertices[t.y], vertices[t.z]);
  }
  return out;
}

TriangleMesh from_cgal(const CgalMesh& mesh) {
  TriangleMesh out;
  std::map<CgalMesh::Vertex_index, std::uint32_t> index;
  for (const auto vertex : mesh.vertices()) {
    index[vertex] = static_cast<std::uint32_t>(out.positions.size());
    const Kernel::Point_3& p = mesh.point(vertex);
    out.positions.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                               CGAL::to_double(p.z()));
  }
  for (const auto face : mesh.faces()) {
    std::vector<std::uint32_t> corners;
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) {
      corners.push_back(index.at(vertex));
    }
    out.triangles.emplace_back(corners.at(0), corners.at(1), corners.at(2));
  }
  out.faces.assign(out.triangles.size(), 0);
  out.face_count = 1;
  return out;
}

CgalMesh combined(Operation operation, CgalMesh a, CgalMesh b) {
  namespace pmp = CGAL::Polygon_mesh_processing;
  if (a.is_empty() || b.is_empty()) {
    const bool first =
        operation == Operation::difference || (operation == Operation::set_union && b.is_empty());
    return first ? a : operation == Operation::set_union ? b : CgalMesh();
  }
  CgalMesh result;
  const bool done =
      operation == Operation::set_union      ? pmp::corefine_and_compute_union(a, b, result)
      : operation == Operation::intersection ? pmp::corefine_and_compute_intersection(a, b, result)
                                             : pmp::corefine_and_compute_difference(a, b, result);
  REQUIRE(done);
  result.collect_garbage();
  return result;
}

std::shared_ptr<const ClosedMesh> evaluated(Operation operation, const TriangleMesh& a,
                                            const TriangleMesh& b) {
  return std::make_shared<const ClosedMesh>(from_cgal(combined(operation, to_cgal(a), to_cgal(b))));
}

TEST_CASE("set operations of meshes agree with CGAL's", "[csg][cgal]") {
  const Operation operation =
      GENERATE(Operation::set_union, Operation::intersection, Operation::difference);
  int lines = 0;
  int boundaries = 0;
  int different = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    Random random(seed);
    const TriangleMesh a = dented_ball(random, glm::dvec3(0.0));
    const TriangleMesh b = dented_ball(random, {uniform(random, 0.3, 0.8), 0.2, 0.1});
    const auto expected = evaluated(operation, a, b);
    CsgTree tree;
    const std::array operands{
        tree.add({.shape = PlacedShape(std::make_shared<const ClosedMesh>(a))}),
        tree.add({.shape = PlacedShape(std::make_shared<const ClosedMesh>(b)),
                  .first_face = SurfaceId{1}})};
    tree.add(operation, operands);
    const Solid solid(std::move(tree));

    Solid::Scratch scratch;
    Crossings crossings;
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec3 from(uniform(random, -3, 3), uniform(random, -3, 3), 4);
      const glm::dvec3 to(uniform(random, -1, 1), uniform(random, -1, 1), 0);
      const Ray ray{.origin = from, .direction = glm::normalize(to - from)};
      solid.cross(ray, scratch);
      crossings.clear();
      expected->cross(ray, crossings);
      ++lines;
      boundaries += static_cast<int>(crossings.size());
      bool same = scratch.boundaries.size() == crossings.size();
      for (std::size_t k = 0; same && k < crossings.size(); ++k) {
        same = std::abs(scratch.boundaries[k].t - crossings[k].t) < 1e-6 &&
               scratch.boundaries[k].entering == crossings[k].entering;
      }
      different += same ? 0 : 1;
    }
  }
  CHECK(boundaries > lines / 2);
  CHECK(different == 0);
}

// A box or a mesh, anywhere and turned, of which CGAL has the very same.
PlacedShape polyhedral_shape(Random& random) {
  const glm::dvec3 at(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
  glm::dmat4 matrix = glm::rotate(glm::translate(glm::dmat4(1.0), at), uniform(random, 0, 6),
                                  glm::normalize(glm::dvec3(1, uniform(random, 0, 1), 2)));
  if (random() % 2 == 0) {
    const glm::dvec3 size(uniform(random, 0.5, 2), uniform(random, 0.5, 2),
                          uniform(random, 0.5, 2));
    return PlacedShape(Box{.size = size}, Affine(matrix));
  }
  if (random() % 3 == 0) {
    matrix[0] *= -1.0;  // mirrored
  }
  return PlacedShape(std::make_shared<const ClosedMesh>(dented_ball(random, glm::dvec3(0.0), 6, 3)),
                     Affine(matrix));
}

CgalMesh to_cgal(const PlacedShape& shape) {
  const auto* box = std::get_if<Box>(&shape.shape());
  TriangleMesh mesh =
      box != nullptr ? box_mesh(box->size) : std::get<MeshShape>(shape.shape())->mesh();
  for (glm::dvec3& position : mesh.positions) {
    position = shape.transform().point(position);
  }
  for (glm::uvec3& triangle : mesh.triangles) {
    if (shape.transform().mirrored()) {
      std::swap(triangle.y, triangle.z);
    }
  }
  return to_cgal(mesh);
}

CgalMesh evaluated(const Expression& e, const std::vector<CsgLeaf>& leaves) {
  if (e.operands.empty()) {
    return to_cgal(leaves[e.leaf].shape);
  }
  CgalMesh result = evaluated(e.operands.front(), leaves);
  for (std::size_t i = 1; i < e.operands.size(); ++i) {
    result = combined(e.operation, std::move(result), evaluated(e.operands[i], leaves));
  }
  return result;
}

using Places = std::vector<std::pair<double, bool>>;

// Where the line enters and leaves, but for pieces and gaps too thin for rounding to keep.
Places without_thin(const Places& places) {
  Places kept;
  for (const auto& place : places) {
    if (!kept.empty() && place.first - kept.back().first < 1e-5) {
      kept.pop_back();
    } else {
      kept.push_back(place);
    }
  }
  return kept;
}

TEST_CASE("random trees of meshes and shapes agree with CGAL's", "[csg][cgal]") {
  int trees = 0;
  int boundaries = 0;
  int different = 0;
  for (unsigned seed = 1; trees < 250; ++seed) {
    const Model model = any_model(seed, polyhedral_shape);
    if (model.leaves.size() < 3 || model.leaves.size() > 8) {
      continue;
    }
    ++trees;
    const CgalMesh mesh = evaluated(model.expression, model.leaves);
    std::optional<ClosedMesh> expected;
    if (!mesh.is_empty()) {
      expected.emplace(from_cgal(mesh));
    }
    const Solid solid = solid_of(model);
    Solid::Scratch scratch;
    Random random(seed);
    for (int i = 0; i < 500; ++i) {
      const glm::dvec3 from(uniform(random, -4, 4), uniform(random, -4, 4), uniform(random, 2, 5));
      const glm::dvec3 to(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
      const Ray ray{.origin = from, .direction = glm::normalize(to - from)};
      Places ours;
      solid.cross(ray, scratch);
      for (const Boundary& boundary : scratch.boundaries) {
        ours.emplace_back(boundary.t, boundary.entering);
      }
      Places theirs;
      if (expected) {
        Crossings crossings;
        expected->cross(ray, crossings);
        for (const Crossing& crossing : crossings) {
          theirs.emplace_back(crossing.t, crossing.entering);
        }
      }
      ours = without_thin(ours);
      theirs = without_thin(theirs);
      boundaries += static_cast<int>(theirs.size());
      bool same = ours.size() == theirs.size();
      for (std::size_t k = 0; same && k < ours.size(); ++k) {
        same =
            std::abs(ours[k].first - theirs[k].first) < 1e-6 && ours[k].second == theirs[k].second;
      }
      different += same ? 0 : 1;
    }
  }
  CAPTURE(trees, boundaries);
  CHECK(boundaries > 80'000);
  CHECK(different == 0);
}

}  // namespace
}  // namespace raycat
