#include "reference/surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "reference/coincidence.hpp"
#include "reference/triangle.hpp"

namespace raycat::reference {
namespace {

const Material& made_of(const Scene& scene, MaterialId id) {
  return scene.materials[static_cast<std::size_t>(id)];
}

SurfaceId face(SurfaceId first, std::uint32_t number) {
  return SurfaceId{static_cast<std::uint32_t>(first) + number};
}

// Among surfaces that lie in one, those that let light through are outside, then the least id.
auto rank(const Meeting& m) { return std::tuple(!transmits(*m.material), m.surface); }

// Of two surfaces in one place, each moved into its own object by its rank: is `b` further along
// `direction` than `a`?
bool behind(const Vec& direction, const Meeting& a, const Meeting& b) {
  const bool a_enters = glm::dot(direction, a.normal) < 0.0L;  // moved along the line
  const bool b_enters = glm::dot(direction, b.normal) < 0.0L;
  if (a_enters != b_enters) {
    return b_enters;
  }
  return a_enters ? rank(a) < rank(b) : rank(b) < rank(a);
}

}  // namespace

Surroundings::Surroundings(const Scene& scene) : scene_(scene) {
  for (const SolidObject& object : scene.solids) {
    solids_.emplace_back(object.solid.tree());
  }
  for (const MeshInstance& instance : scene.meshes) {
    const SurfaceMesh& mesh = *instance.mesh;
    const Place place(instance.transform);
    for (std::size_t i = 0; i < mesh.triangles.triangles.size(); ++i) {
      const glm::uvec3& t = mesh.triangles.triangles[i];
      Facet facet;
      std::array<Vec, 3> local;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t corner = t[static_cast<int>(k)];
        local[k] = Vec(mesh.triangles.positions[corner]);
        facet.corners[k] = place.point(local[k]);
        if (!mesh.normals.empty()) {
          facet.mesh_normals[k] = Vec(mesh.normals[corner]);
        }
      }
      facet.normal = place.normal(glm::cross(local[1] - local[0], local[2] - local[0]));
      facet.instance = &instance;
      facet.surface = face(instance.first_face, mesh.triangles.faces[i]);
      facets_.push_back(facet);
    }
  }
  const Bounds box = bounds(scene);
  if (!box.empty()) {
    size_ = glm::length(Vec(box.half_size()));
  }
}

void Surroundings::add_solids(const Line& line, std::vector<Meeting>& out) const {
  for (std::size_t i = 0; i < solids_.size(); ++i) {
    const SolidObject& object = scene_.solids[i];
    for (const Boundary& boundary : solids_[i](line)) {
      const SurfaceId surface =
          face(object.solid.tree().leaves()[boundary.leaf].first_face, boundary.face);
      out.push_back({.t = boundary.t,
                     .normal = boundary.normal,
                     .entering = boundary.entering,
                     .surface = surface,
                     .object = scene_.surfaces.object(surface),
                     .material = &made_of(scene_, object.materials[boundary.leaf])});
    }
  }
}

void Surroundings::add_meshes(const Line& line, std::vector<Meeting>& out) const {
  const std::size_t begin = out.size();
  for (const Facet& facet : facets_) {
    const auto hit = meet(line, facet.corners[0], facet.corners[1], facet.corners[2]);
    if (!hit) {
      continue;
    }
    const Material& material = made_of(scene_, facet.instance->material);
    if (material.alpha < material.alpha_cutoff) {
      continue;  // no surface (MASK)
    }
    const Meeting meeting{.t = hit->t,
                          .normal = facet.normal,
                          .entering = glm::dot(line.direction, facet.normal) < 0.0L,
                          .surface = facet.surface,
                          .object = scene_.surfaces.object(facet.surface),
                          .material = &material,
                          .facet = &facet,
                          .weights = {1.0L - hit->v - hit->w, hit->v, hit->w}};
    // Where triangles of one surface share an edge, both are met.
    const bool met = std::any_of(
        out.begin() + static_cast<std::ptrdiff_t>(begin), out.end(), [&](const Meeting& other) {
          return other.surface == meeting.surface && other.entering == meeting.entering &&
                 std::abs(other.t - meeting.t) < 1e-14L * size_;
        });
    if (!met) {
      out.push_back(meeting);
    }
  }
}

bool Surroundings::in_one_place(const Vec& direction, const Meeting& a, const Meeting& b) const {
  return in_one_surface(direction, a.t, a.normal, b.t, b.normal, coincident * size_);
}

Vec Surroundings::shading_normal(const Meeting& meeting) {
  if (meeting.facet == nullptr || !meeting.facet->smooth()) {
    return meeting.normal;
  }
  Vec local(0.0L);
  for (std::size_t k = 0; k < 3; ++k) {
    local += meeting.weights[static_cast<int>(k)] * meeting.facet->mesh_normals[k];
  }
  const Vec normal = Place(meeting.facet->instance->transform).normal(local);
  return glm::dot(normal, meeting.normal) > 0.0L ? normal : meeting.normal;
}

Vec Surroundings::lifted(const Meeting& meeting, const Vec& point, Real side) {
  Vec result(point);
  if (meeting.facet == nullptr || !meeting.facet->smooth()) {
    return result;
  }
  const Place place(meeting.facet->instance->transform);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec normal = side * place.normal(meeting.facet->mesh_normals[k]);
    const Real above = glm::dot(point - meeting.facet->corners[k], normal);
    if (above < 0.0L && glm::dot(normal, side * meeting.normal) > 0.0L) {
      result -= meeting.weights[static_cast<int>(k)] * above * normal;
    }
  }
  return result;
}

std::vector<Meeting> Surroundings::ahead(const Way& way) const {
  const Vec& direction = way.line.direction;
  std::vector<Meeting> all;
  add_solids(way.line, all);
  add_meshes(way.line, all);
  std::vector<Meeting> result;
  for (const Meeting& meeting : all) {
    if (way.from && in_one_place(direction, *way.from, meeting)) {
      const bool itself =
          meeting.surface == way.from->surface && glm::dot(meeting.normal, way.from->normal) > 0.0L;
      if (itself ? std::abs(meeting.t) > 1e3L * hair() && meeting.t > 0.0L
                 : behind(direction, *way.from, meeting)) {
        result.push_back(meeting);
      }
    } else if (meeting.t > hair()) {
      result.push_back(meeting);
    }
  }
  // Those in the place that is left have parameters around zero.
  const auto left = std::stable_partition(result.begin(), result.end(), [&](const Meeting& m) {
    return way.from && in_one_place(direction, *way.from, m) && m.surface != way.from->surface;
  });
  std::sort(result.begin(), left,
            [&](const Meeting& a, const Meeting& b) { return behind(direction, a, b); });
  std::sort(left, result.end(), [](const Meeting& a, const Meeting& b) { return a.t < b.t; });
  for (auto begin = left; begin != result.end();) {
    const auto end = std::find_if_not(
        begin, result.end(), [&](const Meeting& m) { return in_one_place(direction, *begin, m); });
    std::sort(begin, end,
              [&](const Meeting& a, const Meeting& b) { return behind(direction, a, b); });
    begin = end;
  }
  return result;
}

}  // namespace raycat::reference
