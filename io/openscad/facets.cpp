#include "io/openscad/facets.hpp"

namespace raycat::openscad {
namespace {

// Appends a circle's corners and returns the number of the first.
std::uint32_t add_circle(Facets& facets, double radius, double z, std::uint32_t count) {
  const auto first = static_cast<std::uint32_t>(facets.points.size());
  for (const glm::dvec2& corner : circle_corners(radius, count)) {
    facets.points.emplace_back(corner, z);
  }
  return first;
}

void add_polygon(Facets& facets, std::vector<std::uint32_t> corners, std::uint32_t surface) {
  facets.polygons.push_back(std::move(corners));
  facets.surface.push_back(surface);
}

void add_cap(Facets& facets, std::uint32_t first, std::uint32_t count, bool upwards,
             std::uint32_t surface) {
  std::vector<std::uint32_t> corners(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    corners[i] = first + (upwards ? i : count - 1 - i);
  }
  add_polygon(facets, std::move(corners), surface);
}

void add_band(Facets& facets, std::uint32_t lower, std::uint32_t upper, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    add_polygon(facets, {lower + i, lower + next, upper + next, upper + i}, 0);
  }
}

}  // namespace

std::vector<glm::dvec2> circle_corners(double radius, std::uint32_t count) {
  std::vector<glm::dvec2> corners(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    corners[i] = radius * unit_vector(360.0 * i / count);
  }
  return corners;
}

std::uint64_t sphere_triangles(std::uint32_t count) {
  return std::uint64_t{count} * ((std::uint64_t{count} + 1) / 2) * 2;
}

std::uint64_t cylinder_triangles(std::uint32_t count) { return std::uint64_t{count} * 4; }

Facets facet_sphere(double radius, std::uint32_t count) {
  Facets facets;
  const std::uint32_t rings = (count + 1) / 2;
  std::uint32_t upper = 0;
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    const glm::dvec2 pole = radius * unit_vector(180.0 * (ring + 0.5) / rings);
    const std::uint32_t lower = add_circle(facets, pole.y, pole.x, count);
    if (ring == 0) {
      add_cap(facets, lower, count, true, 0);
    } else {
      add_band(facets, lower, upper, count);
    }
    upper = lower;
  }
  add_cap(facets, upper, count, false, 0);
  return facets;
}

Facets facet_cylinder(double height, double radius_bottom, double radius_top, std::uint32_t count) {
  Facets facets;
  std::uint32_t surface = 1;
  const std::uint32_t bottom =
      add_circle(facets, radius_bottom, 0.0, radius_bottom > 0.0 ? count : 1);
  if (radius_bottom > 0.0) {
    add_cap(facets, bottom, count, false, surface++);
  }
  const std::uint32_t top = add_circle(facets, radius_top, height, radius_top > 0.0 ? count : 1);
  if (radius_top > 0.0) {
    add_cap(facets, top, count, true, surface);
  }
  if (radius_bottom > 0.0 && radius_top > 0.0) {
    add_band(facets, bottom, top, count);
    return facets;
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    add_polygon(facets,
                radius_bottom > 0.0 ? std::vector{bottom + i, bottom + next, top}
                                    : std::vector{bottom, top + next, top + i},
                0);
  }
  return facets;
}

}  // namespace raycat::openscad
