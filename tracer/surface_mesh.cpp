#include "tracer/surface_mesh.hpp"

namespace raycat {
namespace {

// The value at a point of what each vertex has a value of.
template <class Vector>
Vector interpolated(const std::vector<Vector>& values, const MeshPoint& point) {
  using Real = typename Vector::value_type;
  const glm::uvec3 i = point.mesh.triangles.triangles[point.triangle];
  const auto v = glm::vec<2, Real>(point.barycentric);
  return (Real{1} - v.x - v.y) * values[i.x] + v.x * values[i.y] + v.y * values[i.z];
}

}  // namespace

std::optional<glm::dvec2> MeshPoint::on(const TexturePlace& place) const {
  const auto& sets = mesh.texture_coordinates;
  if (place.coordinates >= sets.size() || sets[place.coordinates].empty()) {
    return std::nullopt;
  }
  return place.transform * glm::dvec3(interpolated(sets[place.coordinates], *this), 1.0);
}

glm::vec4 MeshPoint::colour() const {
  return mesh.colours.empty() ? glm::vec4(1.0f) : interpolated(mesh.colours, *this);
}

std::uint32_t MeshPoint::mapped_face() const {
  const FeatureMap& map = *mesh.features;
  return map.faces[map.grid.nearest(on(map.place).value_or(glm::dvec2(0.0)))];
}

}  // namespace raycat
