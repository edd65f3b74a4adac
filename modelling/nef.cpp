#include "modelling/nef.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <queue>
#include <stdexcept>
#include <utility>
#include <vector>

#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <CGAL/convex_decomposition_3.h>

#include "geometry/disjoint_sets.hpp"
#include "geometry/edge_uses.hpp"
#include "modelling/convex_hull.hpp"
#include "modelling/exact.hpp"

namespace raycat {
namespace {

using Nef = CGAL::Nef_polyhedron_3<Exact>;
using Polyhedron = CGAL::Polyhedron_3<Exact>;

class Builder : public CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
 public:
  explicit Builder(const TriangleMesh& mesh) : mesh_(mesh) {}

  void operator()(Polyhedron::HalfedgeDS& to) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> builder(to, false);
    builder.begin_surface(mesh_.positions.size(), mesh_.triangles.size());
    for (const glm::dvec3& p : mesh_.positions) {
      builder.add_vertex(Exact::Point_3(p.x, p.y, p.z));
    }
    for (const glm::uvec3& t : mesh_.triangles) {
      const std::array<std::size_t, 3> corners{t.x, t.y, t.z};
      if (!builder.test_facet(corners.begin(), corners.end())) {
        throw std::runtime_error("the surface touches itself along an edge");
      }
      builder.add_facet(corners.begin(), corners.end());
    }
    builder.end_surface();
    builder.remove_unconnected_vertices();
  }

 private:
  const TriangleMesh& mesh_;
};

Nef filled(const TriangleMesh& shell) {
  Polyhedron polyhedron;
  Builder builder(shell);
  polyhedron.delegate(builder);
  if (!polyhedron.is_closed()) {
    throw std::runtime_error("the surface is not closed");
  }
  return Nef(polyhedron);
}

// The parts of a surface that no edge joins.
std::vector<TriangleMesh> shells(const TriangleMesh& mesh) {
  DisjointSets joined(mesh.triangles.size());
  const EdgeUses edges(mesh.triangles, mesh.positions.size());
  edges.for_each([&](std::span<const std::uint32_t> uses) {
    for (const std::uint32_t half : uses) {
      joined.join(uses.front() / 3, half / 3);
    }
  });
  std::map<std::uint32_t, std::vector<glm::uvec3>> shell_of;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    shell_of[joined.first(i)].push_back(mesh.triangles[i]);
  }
  std::vector<TriangleMesh> out;
  std::vector<std::uint32_t> number(mesh.positions.size());
  std::vector<std::size_t> numbered_in(mesh.positions.size(), 0);
  for (const auto& [first, triangles] : shell_of) {
    TriangleMesh& shell = out.emplace_back();
    for (const glm::uvec3& triangle : triangles) {
      glm::uvec3& corners = shell.triangles.emplace_back();
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t corner = triangle[k];
        if (numbered_in[corner] != out.size()) {
          numbered_in[corner] = out.size();
          number[corner] = static_cast<std::uint32_t>(shell.positions.size());
          shell.positions.push_back(mesh.positions[corner]);
        }
        corners[k] = number[corner];
      }
    }
  }
  return out;
}

// What a closed mesh encloses, cavities left out: from the largest shell to the smallest, of which
// those turned inside out are cavities.
Nef nef_of(const TriangleMesh& mesh) {
  std::vector<std::pair<double, TriangleMesh>> all;
  for (TriangleMesh& shell : shells(mesh)) {
    const double volume = signed_volume(shell);
    all.emplace_back(volume, std::move(shell));
  }
  std::ranges::sort(
      all, [](const auto& a, const auto& b) { return std::abs(a.first) > std::abs(b.first); });
  Nef nef;
  for (auto& [volume, shell] : all) {
    if (volume > 0.0) {
      nef += filled(shell);
      continue;
    }
    for (glm::uvec3& triangle : shell.triangles) {
      std::swap(triangle.y, triangle.z);
    }
    nef -= filled(shell);
  }
  return nef;
}

TriangleMesh mesh_of(const Nef& nef) {
  std::vector<Exact::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  CGAL::convert_nef_polyhedron_to_polygon_soup(nef, points, polygons, true);
  TriangleMesh mesh;
  for (const Exact::Point_3& point : points) {
    mesh.positions.push_back(rounded(point));
  }
  for (const std::vector<std::size_t>& corners : polygons) {
    mesh.triangles.emplace_back(corners.at(0), corners.at(1), corners.at(2));
  }
  mesh.faces.assign(mesh.triangles.size(), 0);
  mesh.face_count = mesh.triangles.empty() ? 0 : 1;
  return mesh;
}

// Only rounding may keep the volumes of a convex body and of its hull apart.
bool is_convex(const TriangleMesh& mesh, const TriangleMesh& hull) {
  constexpr double rounding = 1e-9;
  return signed_volume(mesh) >= (1.0 - rounding) * signed_volume(hull);
}

}  // namespace

std::vector<std::vector<glm::dvec3>> convex_parts(const TriangleMesh& mesh) {
  const TriangleMesh hull = convex_hull(mesh.positions);
  if (is_convex(mesh, hull)) {
    return {hull.positions};
  }
  Nef nef = nef_of(mesh);
  CGAL::convex_decomposition_3(nef);
  std::vector<std::vector<glm::dvec3>> parts;
  for (auto part = ++nef.volumes_begin(); part != nef.volumes_end(); ++part) {  // past the outside
    if (!part->mark()) {
      continue;
    }
    Polyhedron convex;
    nef.convert_inner_shell_to_polyhedron(part->shells_begin(), convex);
    std::vector<glm::dvec3>& corners = parts.emplace_back();
    for (auto vertex = convex.vertices_begin(); vertex != convex.vertices_end(); ++vertex) {
      corners.push_back(rounded(vertex->point()));
    }
  }
  return parts;
}

TriangleMesh united(std::span<const TriangleMesh> meshes) {
  // The smallest first, so that few are large.
  const auto larger = [](const Nef& p, const Nef& q) {
    return p.number_of_vertices() > q.number_of_vertices();
  };
  std::priority_queue<Nef, std::vector<Nef>, decltype(larger)> waiting(larger);
  for (const TriangleMesh& mesh : meshes) {
    waiting.push(nef_of(mesh));
  }
  while (waiting.size() > 1) {
    const Nef first = waiting.top();
    waiting.pop();
    const Nef second = waiting.top();
    waiting.pop();
    waiting.push(first + second);
  }
  return mesh_of(waiting.top());
}

}  // namespace raycat
