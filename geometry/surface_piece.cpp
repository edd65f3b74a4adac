#include "geometry/surface_piece.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

#include "geometry/frustum.hpp"

namespace raycat {
namespace {

using Kind = CurvedSurface::Kind;

// Around an axis; a capsule's lower and upper ball.
constexpr int around = 8;
constexpr std::uint32_t lower_ball = 1;

// A shape's frame, relative to a point of the world.
struct Frame {
  glm::dmat3 linear;
  glm::dvec3 origin;
  glm::dmat3 inverse;
  bool mirrored;

  Frame(const Affine& transform, const glm::dvec3& from)
      : linear(transform.matrix()),
        origin(transform.translation() - from),
        inverse(transform.inverse_linear()),
        mirrored(transform.mirrored()) {}

  glm::dvec3 point(const glm::dvec3& local) const { return linear * local + origin; }
};

glm::dvec3 on_circle(int step, double radius, double height) {
  const double angle = 2.0 * std::numbers::pi * step / around;
  return {radius * std::cos(angle), height, radius * std::sin(angle)};
}

// The plane through what `samples` are of, with two sides in the shape's frame that run around its
// outward normal, or the other way if the frame is mirrored.
bool set_plane(const Frame& frame, const glm::dvec3& u, const glm::dvec3& v, double share,
               SurfacePiece& out) {
  const glm::dvec3 along = frame.linear * u;
  const glm::dvec3 up = frame.linear * v;
  const glm::dvec3 across = frame.mirrored ? glm::cross(up, along) : glm::cross(along, up);
  const double area = glm::length(across);
  const double longest = std::max({glm::length(along), glm::length(up), glm::length(along - up)});
  if (!(area > 0.0)) {
    return false;
  }
  out.planar = true;
  out.plane.normal = across / area;
  out.plane.offset = glm::dot(out.plane.normal, out.samples.front());
  out.extent = share * area;
  out.width = area / longest;
  return true;
}

CurvedSurface curved(const Frame& frame, Kind kind, double radius, double other) {
  CurvedSurface surface{.kind = kind,
                        .radius = radius,
                        .other = other,
                        .inverse = frame.inverse,
                        .origin = frame.origin,
                        .middle = frame.origin};
  if (kind == Kind::ball) {
    surface.middle = frame.point({0.0, other, 0.0});
    const glm::dmat3& m = frame.linear;
    surface.spread =
        radius *
        std::sqrt((glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2])) / 3.0);
    return surface;
  }
  surface.axis = glm::normalize(frame.linear[1]);
  if (kind == Kind::cone) {
    surface.middle -= surface.axis * glm::dot(surface.axis, surface.middle);
  }
  return surface;
}

double shortest_axis(const Frame& frame) {
  return std::min(
      {glm::length(frame.linear[0]), glm::length(frame.linear[1]), glm::length(frame.linear[2])});
}

bool set_ball(const Frame& frame, double radius, double height, SurfacePiece& out) {
  if (!(radius > 0.0)) {
    return false;
  }
  out.planar = false;
  out.curved = curved(frame, Kind::ball, radius, height);
  out.extent = out.curved.spread * out.curved.spread;
  out.width = radius * shortest_axis(frame);
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x != 0 || y != 0 || z != 0) {
          out.samples.push_back(frame.point(radius * glm::normalize(glm::dvec3(x, y, z)) +
                                            glm::dvec3(0.0, height, 0.0)));
        }
      }
    }
  }
  return true;
}

bool set_cone(const Frame& frame, const Frustum& side, SurfacePiece& out) {
  out.planar = false;
  out.curved = curved(frame, Kind::cone, side.radius - side.slope * side.middle, side.slope);
  const double height = 2.0 * side.half_height * glm::length(frame.linear[1]);
  out.extent = height * side.radius * (glm::length(frame.linear[0]) + glm::length(frame.linear[2]));
  out.width = height;
  for (const double y : {-side.half_height, side.half_height}) {
    const double radius = std::max(0.0, side.radius + side.slope * y);
    for (int step = 0; step < around; ++step) {
      out.samples.push_back(frame.point(on_circle(step, radius, side.middle + y)));
    }
  }
  return true;
}

bool set_one(const Sphere& sphere, std::uint32_t /*piece*/, const Frame& frame, double /*reach*/,
             SurfacePiece& out) {
  return set_ball(frame, sphere.radius, 0.0, out);
}

bool set_one(const Box& box, std::uint32_t piece, const Frame& frame, double /*reach*/,
             SurfacePiece& out) {
  const auto axis = static_cast<int>(piece / 2);
  const glm::dvec3 half = 0.5 * box.size;
  glm::dvec3 side(0.0);
  side[axis] = piece % 2 == 0 ? -half[axis] : half[axis];
  glm::dvec3 u(0.0);
  glm::dvec3 v(0.0);
  const int first = piece % 2 == 0 ? (axis + 2) % 3 : (axis + 1) % 3;
  const int second = piece % 2 == 0 ? (axis + 1) % 3 : (axis + 2) % 3;
  u[first] = half[first];
  v[second] = half[second];
  for (const glm::dvec3& corner : {-u - v, u - v, u + v, v - u}) {
    out.samples.push_back(frame.point(side + corner));
  }
  return set_plane(frame, 2.0 * u, 2.0 * v, 1.0, out);
}

bool set_one(const Cylinder& cylinder, std::uint32_t piece, const Frame& frame, double /*reach*/,
             SurfacePiece& out) {
  if (piece == 0) {
    return set_cone(frame, side_of(cylinder), out);
  }
  const bool bottom = piece == 1 && cylinder.radius_bottom > 0.0;
  const double radius = bottom ? cylinder.radius_bottom : cylinder.radius_top;
  const double height = bottom ? -0.5 * cylinder.height : 0.5 * cylinder.height;
  for (int step = 0; step < around; ++step) {
    out.samples.push_back(frame.point(on_circle(step, radius, height)));
  }
  const glm::dvec3 x(2.0 * radius, 0.0, 0.0);
  const glm::dvec3 z(0.0, 0.0, 2.0 * radius);
  return set_plane(frame, bottom ? x : z, bottom ? z : x, 0.25 * std::numbers::pi, out);
}

bool set_one(const Capsule& capsule, std::uint32_t piece, const Frame& frame, double /*reach*/,
             SurfacePiece& out) {
  if (piece == 0) {
    const std::optional<Frustum> side = side_of(capsule);
    return side && set_cone(frame, *side, out);
  }
  return piece == lower_ball ? set_ball(frame, capsule.radius_bottom, -0.5 * capsule.height, out)
                             : set_ball(frame, capsule.radius_top, 0.5 * capsule.height, out);
}

bool set_one(const HalfSpace& /*half_space*/, std::uint32_t /*piece*/, const Frame& frame,
             double reach, SurfacePiece& out) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.0, 1.0, 0.0) * frame.inverse);
  const double offset = glm::dot(normal, frame.origin);
  const glm::dvec3 u = reach * glm::normalize(frame.linear[0]);
  const glm::dvec3 v = glm::cross(normal, u);
  for (const glm::dvec3& corner : {-u - v, u - v, u + v, v - u}) {
    out.samples.push_back(offset * normal + corner);
  }
  out.planar = true;
  out.plane = {.normal = normal, .offset = offset};
  out.extent = std::numeric_limits<double>::infinity();
  out.width = 2.0 * reach;
  return true;
}

bool set_one(const Torus& torus, std::uint32_t /*piece*/, const Frame& frame, double /*reach*/,
             SurfacePiece& out) {
  out.planar = false;
  out.curved = curved(frame, Kind::torus, torus.radius, torus.tube);
  out.width = (torus.radius + torus.tube) * shortest_axis(frame);
  out.extent = out.width * out.width;
  for (int turn = 0; turn < around; ++turn) {
    // On the outer half of the tube, which a spindle has as well.
    for (const double angle : {-0.5, -0.25, 0.0, 0.25, 0.5}) {
      const double from_axis = torus.radius + torus.tube * std::cos(angle * std::numbers::pi);
      out.samples.push_back(
          frame.point(on_circle(turn, from_axis, torus.tube * std::sin(angle * std::numbers::pi))));
    }
  }
  return true;
}

bool set_one(const MeshShape& /*mesh*/, std::uint32_t /*piece*/, const Frame& /*frame*/,
             double /*reach*/, SurfacePiece& /*out*/) {
  return false;  // see `set_triangle`
}

}  // namespace

double Plane::distance(const glm::dvec3& point) const noexcept {
  return std::abs(glm::dot(normal, point) - offset);
}

double Plane::passage(const Ray& line) const noexcept {
  return (offset - glm::dot(normal, line.origin)) / glm::dot(normal, line.direction);
}

double CurvedSurface::distance(const glm::dvec3& point) const noexcept {
  const glm::dvec3 p = inverse * (point - origin);
  double value = 0.0;
  glm::dvec3 gradient(0.0);
  switch (kind) {
    case Kind::ball: {
      const glm::dvec3 out = p - glm::dvec3(0.0, other, 0.0);
      const double length = glm::length(out);
      value = length - radius;
      gradient = length > 0.0 ? out / length : glm::dvec3(1.0, 0.0, 0.0);
      break;
    }
    case Kind::cone: {
      const double from_axis = std::hypot(p.x, p.z);
      value = from_axis - (radius + other * p.y);
      gradient = from_axis > 0.0 ? glm::dvec3(p.x / from_axis, -other, p.z / from_axis)
                                 : glm::dvec3(1.0, -other, 0.0);
      break;
    }
    case Kind::torus: {
      const double from_axis = std::hypot(p.x, p.z);
      const double from_ring = from_axis - radius;
      const double from_tube = std::hypot(from_ring, p.y);
      value = from_tube - other;
      gradient = from_axis > 0.0 && from_tube > 0.0
                     ? glm::dvec3(p.x / from_axis * from_ring, p.y, p.z / from_axis * from_ring) /
                           from_tube
                     : glm::dvec3(0.0, 1.0, 0.0);
      break;
    }
  }
  return std::abs(value) / glm::length(gradient * inverse);
}

double CurvedSurface::passage(const Ray& line, double t, bool inwards) const {
  const Ray local{.origin = inverse * (line.origin - origin),
                  .direction = inverse * line.direction};
  if (kind == Kind::torus) {
    thread_local Crossings crossings;
    crossings.clear();
    cross(Torus{.radius = radius, .tube = other}, local, crossings);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Crossing& crossing : crossings) {
      if (crossing.entering == inwards && std::abs(crossing.t - t) < std::abs(nearest - t)) {
        nearest = crossing.t;
      }
    }
    return nearest;
  }
  // From the point next to the middle of a ball, or to the axis' foot of a cone, a point at s is
  // within where a s^2 + 2 b s + c is negative.
  const bool ball = kind == Kind::ball;
  const glm::dvec3 centre(0.0, ball ? other : 0.0, 0.0);
  const glm::dvec3& d = local.direction;
  const double shift = -glm::dot(local.origin - centre, d) / glm::dot(d, d);
  const glm::dvec3 p = local.at(shift) - centre;
  const double slope = ball ? 0.0 : other;
  const double r = radius + slope * p.y;
  const double m = slope * d.y;
  const double up = ball ? 1.0 : 0.0;
  const double a = d.x * d.x + d.z * d.z + up * d.y * d.y - m * m;
  const double b = p.x * d.x + p.z * d.z + up * p.y * d.y - r * m;
  const double c = p.x * p.x + p.z * p.z + up * p.y * p.y - r * r;
  const double root = std::sqrt(b * b - a * c);  // not a number if the line passes by
  // The passage inwards is (-b - root) / a, whatever the sign of a.
  const double s =
      inwards == (b >= 0.0) ? -(b + std::copysign(root, b)) / a : c / -(b + std::copysign(root, b));
  return shift + s;
}

std::uint32_t piece_count(const Shape& shape) {
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) {
    return static_cast<std::uint32_t>((*mesh)->mesh().triangles.size());
  }
  return std::holds_alternative<Capsule>(shape) ? 3 : face_count(shape);
}

bool set_piece(const PlacedShape& shape, std::uint32_t piece, const glm::dvec3& from, double reach,
               SurfacePiece& out) {
  out.samples.clear();
  const Frame frame(shape.transform(), from);
  return std::visit([&](const auto& one) { return set_one(one, piece, frame, reach, out); },
                    shape.shape());
}

bool set_triangle(const TriangleMesh& mesh, std::uint32_t triangle, const Affine& transform,
                  const glm::dvec3& from, SurfacePiece& out) {
  out.samples.clear();
  const Frame frame(transform, from);
  const glm::uvec3& corners = mesh.triangles[triangle];
  const glm::dvec3& a = mesh.positions[corners.x];
  for (int k = 0; k < 3; ++k) {
    out.samples.push_back(frame.point(mesh.positions[corners[k]]));
  }
  return set_plane(frame, mesh.positions[corners.y] - a, mesh.positions[corners.z] - a, 0.5, out);
}

}  // namespace raycat
