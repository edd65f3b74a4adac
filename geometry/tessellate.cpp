#include "geometry/tessellate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

namespace raycat {
namespace {

constexpr double pi = glm::pi<double>();
constexpr double fewest_around = 12.0;
constexpr double most_triangles = 4194304.0;

/// A corner of the outline that is turned around the Y axis, and the face of the piece of outline
/// that leads to it.
struct Outline {
  double radius = 0.0;
  double y = 0.0;
  std::uint32_t face = 0;
};

void require_few(double triangles) {
  if (!(triangles <= most_triangles)) {
    throw std::invalid_argument(
        fmt::format("a curved surface takes at most {:.0f} triangles, but so small a chord error "
                    "takes {:.3g}",
                    most_triangles, triangles));
  }
}

// Into how many parts a full circle is cut so that none is farther than `error` from its chord.
double parts(double radius, double error) {
  const double cosine = std::max(0.0, 1.0 - error / radius);
  const double count = std::max(fewest_around, std::ceil(pi / std::acos(cosine)));
  require_few(count);
  return count;
}

// The outline runs so that the solid is on its left, with the radius to the right and Y up.
class Revolution {
 public:
  explicit Revolution(double around) : around_(static_cast<std::uint32_t>(around)) {}

  void turn(std::span<const Outline> outline, bool closed) {
    require_few(2.0 * around_ * static_cast<double>(outline.size()));
    std::vector<std::uint32_t> first;
    for (const Outline& corner : outline) {
      first.push_back(add_ring(corner));
    }
    for (std::size_t i = closed ? 0 : 1; i < outline.size(); ++i) {
      const std::size_t before = i == 0 ? outline.size() - 1 : i - 1;
      join(outline[before], first[before], outline[i], first[i]);
    }
    mesh.face_count = 1 + *std::ranges::max_element(mesh.faces);
  }

  TriangleMesh mesh;

 private:
  std::uint32_t add_ring(const Outline& corner) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    if (corner.radius == 0.0) {
      mesh.positions.emplace_back(0.0, corner.y, 0.0);
      return first;
    }
    for (std::uint32_t k = 0; k < around_; ++k) {
      const double turn = 2.0 * pi * k / around_;
      mesh.positions.emplace_back(corner.radius * std::sin(turn), corner.y,
                                  corner.radius * std::cos(turn));
    }
    return first;
  }

  void join(const Outline& a, std::uint32_t from, const Outline& b, std::uint32_t to) {
    for (std::uint32_t k = 0; k < around_; ++k) {
      const std::uint32_t next = k + 1 == around_ ? 0 : k + 1;
      if (a.radius != 0.0) {
        add(from + k, from + next, b.radius == 0.0 ? to : to + next, b.face);
      }
      if (b.radius != 0.0) {
        add(a.radius == 0.0 ? from : from + k, to + next, to + k, b.face);
      }
    }
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t face) {
    mesh.triangles.emplace_back(a, b, c);
    mesh.faces.push_back(face);
  }

  std::uint32_t around_;
};

// Adds the arc about (centre, y) from one angle to another, measured from the direction of growing
// radius, without its begin.
void add_arc(std::vector<Outline>& outline, double centre, double y, double radius, double begin,
             double end, double error) {
  const double full = parts(radius, error);
  const auto count =
      std::max(std::size_t{1},
               static_cast<std::size_t>(std::ceil(full * std::abs(end - begin) / (2.0 * pi))));
  for (std::size_t i = 1; i <= count; ++i) {
    const double angle =
        begin + (end - begin) * static_cast<double>(i) / static_cast<double>(count);
    outline.push_back(
        {.radius = centre + radius * std::cos(angle), .y = y + radius * std::sin(angle)});
  }
}

TriangleMesh revolved(std::span<const Outline> outline, double around, bool closed = false) {
  Revolution revolution(around);
  revolution.turn(outline, closed);
  return std::move(revolution.mesh);
}

// Both ways of a doubly curved surface have half of the error.
TriangleMesh tessellate_one(const Sphere& sphere, double error) {
  std::vector<Outline> outline{{.y = -sphere.radius}};
  add_arc(outline, 0.0, 0.0, sphere.radius, -0.5 * pi, 0.5 * pi, 0.5 * error);
  outline.back() = {.y = sphere.radius};
  return revolved(outline, parts(sphere.radius, 0.5 * error));
}

TriangleMesh tessellate_one(const Box& box, double /*error*/) {
  TriangleMesh mesh;
  const glm::dvec3 half = 0.5 * box.size;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.positions.emplace_back((corner & 1) != 0 ? half.x : -half.x,
                                (corner & 2) != 0 ? half.y : -half.y,
                                (corner & 4) != 0 ? half.z : -half.z);
  }
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t u = 1U << (axis + 1) % 3;
    const std::uint32_t v = 1U << (axis + 2) % 3;
    for (std::uint32_t side = 0; side < 2; ++side) {
      const std::uint32_t origin = side << axis;
      const std::uint32_t second = origin + (side == 1 ? u : v);
      const std::uint32_t fourth = origin + (side == 1 ? v : u);
      mesh.triangles.emplace_back(origin, second, origin + u + v);
      mesh.triangles.emplace_back(origin, origin + u + v, fourth);
      mesh.faces.insert(mesh.faces.end(), 2, 2 * axis + side);
    }
  }
  mesh.face_count = 6;
  return mesh;
}

TriangleMesh tessellate_one(const Cylinder& cylinder, double error) {
  const double half = 0.5 * cylinder.height;
  const std::uint32_t top = cylinder.radius_bottom > 0.0 ? 2 : 1;
  std::vector<Outline> outline{{.y = -half}};
  if (cylinder.radius_bottom > 0.0) {
    outline.push_back({.radius = cylinder.radius_bottom, .y = -half, .face = 1});
  }
  outline.push_back({.radius = cylinder.radius_top, .y = half, .face = 0});
  if (cylinder.radius_top > 0.0) {
    outline.push_back({.y = half, .face = top});
  }
  return revolved(outline, parts(std::max(cylinder.radius_top, cylinder.radius_bottom), error));
}

TriangleMesh tessellate_one(const Capsule& capsule, double error) {
  const double half = 0.5 * capsule.height;
  const double fall = capsule.radius_bottom - capsule.radius_top;
  if (std::abs(fall) >= capsule.height) {  // one ball holds the other
    const bool bottom = fall > 0.0;
    TriangleMesh ball = tessellate_one(
        Sphere{.radius = std::max(capsule.radius_bottom, capsule.radius_top)}, error);
    for (glm::dvec3& position : ball.positions) {
      position.y += bottom ? -half : half;
    }
    return ball;
  }
  const double tilt = std::asin(fall / capsule.height);  // of the normals where both balls touch
  std::vector<Outline> outline{{.y = -half - capsule.radius_bottom}};
  if (capsule.radius_bottom > 0.0) {
    add_arc(outline, 0.0, -half, capsule.radius_bottom, -0.5 * pi, tilt, 0.5 * error);
  }
  if (capsule.radius_top > 0.0) {
    outline.push_back({.radius = capsule.radius_top * std::cos(tilt),
                       .y = half + capsule.radius_top * std::sin(tilt)});
    add_arc(outline, 0.0, half, capsule.radius_top, tilt, 0.5 * pi, 0.5 * error);
    outline.back() = {.y = half + capsule.radius_top};
  } else {
    outline.push_back({.y = half});
  }
  return revolved(outline, parts(std::max(capsule.radius_bottom, capsule.radius_top), 0.5 * error));
}

TriangleMesh tessellate_one(const HalfSpace& /*half_space*/, double /*error*/) {
  throw std::invalid_argument("a half-space has no end, so that it cannot be made of triangles");
}

TriangleMesh tessellate_one(const Torus& torus, double error) {
  const double around = parts(torus.radius + torus.tube, 0.5 * error);
  std::vector<Outline> outline;
  if (torus.tube < torus.radius) {
    add_arc(outline, torus.radius, 0.0, torus.tube, 0.0, 2.0 * pi, 0.5 * error);
    return revolved(outline, around, true);
  }
  const double pole = std::acos(std::max(-1.0, -torus.radius / torus.tube));
  const double height = torus.tube * std::sin(pole);
  outline.push_back({.y = -height});
  add_arc(outline, torus.radius, 0.0, torus.tube, -pole, pole, 0.5 * error);
  outline.back() = {.y = height};
  return revolved(outline, around);
}

TriangleMesh tessellate_one(const MeshShape& mesh, double /*error*/) { return mesh->mesh(); }

}  // namespace

TriangleMesh tessellate(const Shape& shape, double chord_error) {
  return std::visit([&](const auto& one) { return tessellate_one(one, chord_error); }, shape);
}

}  // namespace raycat
