#include "reference/shape_passages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <variant>

#include "geometry/mesh.hpp"
#include "reference/polynomial_roots.hpp"
#include "reference/triangle.hpp"

namespace raycat::reference {
namespace {

constexpr int axes = 3;

// c + b t + a t^2, of the product of two linear functions c0 + c1 t.
std::vector<Real> squared(Real c0, Real c1) { return {c0 * c0, 2.0L * c0 * c1, c1 * c1}; }

std::vector<Real> sum(std::vector<Real> a, const std::vector<Real>& b, Real factor) {
  a.resize(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < b.size(); ++i) {
    a[i] += factor * b[i];
  }
  return a;
}

std::vector<Real> product(const std::vector<Real>& a, const std::vector<Real>& b) {
  std::vector<Real> result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      result[i + j] += a[i] * b[j];
    }
  }
  return result;
}

// x^2 + z^2 along the line.
std::vector<Real> off_axis_squared(const Line& line) {
  return sum(squared(line.origin.x, line.direction.x), squared(line.origin.z, line.direction.z),
             1.0L);
}

void add(std::vector<Passage>& out, const std::vector<Real>& ts, const auto& normal_at,
         std::uint32_t face) {
  for (const Real t : ts) {
    out.push_back({.t = t, .normal = normal_at(t), .face = face});
  }
}

// Where the line meets the plane on which its coordinate `axis` is `at`; the normal points outward.
void add_plane(std::vector<Passage>& out, const Line& line, int axis, Real at, Real outward,
               std::uint32_t face) {
  Vec normal(0.0L);
  normal[axis] = outward;
  add(
      out, roots({line.origin[axis] - at, line.direction[axis]}), [&](Real) { return normal; },
      face);
}

// A sphere around a point on the axis.
void add_sphere(std::vector<Passage>& out, const Line& line, Real y, Real radius) {
  std::vector<Real> p = off_axis_squared(line);
  p = sum(p, squared(line.origin.y - y, line.direction.y), 1.0L);
  p[0] -= radius * radius;
  add(
      out, roots(p), [&](Real t) { return glm::normalize(line.at(t) - Vec(0.0L, y, 0.0L)); }, 0);
}

bool inside(const Sphere& s, const Vec& p) { return glm::dot(p, p) < Real(s.radius) * s.radius; }

void add_surfaces(const Sphere& s, const Line& line, std::vector<Passage>& out) {
  add_sphere(out, line, 0.0L, s.radius);
}

bool inside(const Box& box, const Vec& p) {
  bool all = true;
  for (int i = 0; i < axes; ++i) {
    all = all && 2.0L * std::abs(p[i]) < Real(box.size[i]);
  }
  return all;
}

void add_surfaces(const Box& box, const Line& line, std::vector<Passage>& out) {
  for (int i = 0; i < axes; ++i) {
    const Real half = Real(box.size[i]) / 2.0L;
    add_plane(out, line, i, -half, -1.0L, static_cast<std::uint32_t>(2 * i));
    add_plane(out, line, i, half, 1.0L, static_cast<std::uint32_t>(2 * i + 1));
  }
}

// The radius at height y is `middle` + `slope` y.
Real slope(const Cylinder& c) { return (Real(c.radius_top) - c.radius_bottom) / c.height; }
Real middle(const Cylinder& c) { return (Real(c.radius_top) + c.radius_bottom) / 2.0L; }

bool inside(const Cylinder& c, const Vec& p) {
  return 2.0L * std::abs(p.y) < Real(c.height) && std::hypot(p.x, p.z) < middle(c) + slope(c) * p.y;
}

void add_surfaces(const Cylinder& c, const Line& line, std::vector<Passage>& out) {
  const Real k = slope(c);
  const std::vector<Real> side = sum(
      off_axis_squared(line), squared(middle(c) + k * line.origin.y, k * line.direction.y), -1.0L);
  add(
      out, roots(side),
      [&](Real t) {
        const Vec p = line.at(t);
        return glm::normalize(Vec(p.x, -k * std::hypot(p.x, p.z), p.z));
      },
      0);
  std::uint32_t face = 1;
  const Real half = Real(c.height) / 2.0L;
  if (c.radius_bottom > 0.0) {
    add_plane(out, line, 1, -half, -1.0L, face++);
  }
  if (c.radius_top > 0.0) {
    add_plane(out, line, 1, half, 1.0L, face);
  }
}

// A capsule's outline in the plane of y, upwards from the middle of the bottom ball, and of the
// distance r from the axis: two circles and the line that touches both, whose normal is (across,
// along). Nothing if one ball holds the other.
struct Flank {
  Real across, along;
};

std::optional<Flank> flank(const Capsule& c) {
  const Real along = (Real(c.radius_bottom) - c.radius_top) / c.height;
  if (c.height <= 0.0 || std::abs(along) >= 1.0L) {
    return std::nullopt;
  }
  return Flank{.across = std::sqrt(1.0L - along * along), .along = along};
}

bool inside(const Capsule& c, const Vec& p) {
  const Real half = Real(c.height) / 2.0L;
  const Real r = std::hypot(p.x, p.z);
  const Real y = p.y + half;
  if (std::hypot(r, y) < Real(c.radius_bottom) ||
      std::hypot(r, y - Real(c.height)) < Real(c.radius_top)) {
    return true;
  }
  const std::optional<Flank> f = flank(c);
  if (!f) {
    return false;
  }
  const Real up = f->across * y - f->along * r;  // along the touching line
  return up > 0.0L && up < f->across * Real(c.height) &&
         f->across * r + f->along * y < Real(c.radius_bottom);
}

void add_surfaces(const Capsule& c, const Line& line, std::vector<Passage>& out) {
  const Real half = Real(c.height) / 2.0L;
  add_sphere(out, line, -half, c.radius_bottom);
  add_sphere(out, line, half, c.radius_top);
  if (const std::optional<Flank> f = flank(c)) {
    // across r = radius_bottom - along y
    std::vector<Real> cone = off_axis_squared(line);
    cone = sum({0.0L}, cone, f->across * f->across);
    cone = sum(cone,
               squared(Real(c.radius_bottom) - f->along * (line.origin.y + half),
                       -f->along * line.direction.y),
               -1.0L);
    add(
        out, roots(cone),
        [&](Real t) {
          const Vec p = line.at(t);
          const Real r = std::hypot(p.x, p.z);
          return Vec(f->across * p.x / r, f->along, f->across * p.z / r);
        },
        0);
  }
}

bool inside(const HalfSpace&, const Vec& p) { return p.y < 0.0L; }

void add_surfaces(const HalfSpace&, const Line& line, std::vector<Passage>& out) {
  add_plane(out, line, 1, 0.0L, 1.0L, 0);
}

bool inside(const Torus& torus, const Vec& p) {
  return std::hypot(std::hypot(p.x, p.z) - Real(torus.radius), p.y) < Real(torus.tube);
}

// (|p|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2), from the point of the line that is nearest to the
// middle, where the coefficients are smallest. A spindle's inner surface is a root too.
void add_surfaces(const Torus& torus, const Line& line, std::vector<Passage>& out) {
  const Real start =
      -glm::dot(line.origin, line.direction) / glm::dot(line.direction, line.direction);
  const Line near{.origin = line.at(start), .direction = line.direction};
  const Real ring = torus.radius;
  const Real tube = torus.tube;
  const std::vector<Real> off_axis = off_axis_squared(near);
  std::vector<Real> k = sum(off_axis, squared(near.origin.y, near.direction.y), 1.0L);
  k[0] += ring * ring - tube * tube;
  for (const Real t : roots(sum(product(k, k), off_axis, -4.0L * ring * ring))) {
    const Vec p = near.at(t);
    const Real r = std::hypot(p.x, p.z);
    out.push_back({.t = start + t,
                   .normal = glm::normalize(Vec(p.x - ring * p.x / r, p.y, p.z - ring * p.z / r)),
                   .face = 0});
  }
}

// How often the mesh winds round the point: the passages out of it less those into it, along a ray
// that comes by no edge.
bool inside(const MeshShape& shape, const Vec& p) {
  constexpr std::array directions{Vec(0.6180339887L, 0.5432112345L, 0.5671234987L),
                                  Vec(-0.4142135623L, 0.7320508075L, 0.2360679774L),
                                  Vec(0.3141592653L, -0.2718281828L, 0.9159655941L)};
  int winding = 0;
  for (const Vec& direction : directions) {
    winding = 0;
    bool clear = true;
    const TriangleMesh& mesh = shape->mesh();
    for (const glm::uvec3& t : mesh.triangles) {
      const std::optional<TriangleHit> hit =
          meet({.origin = p, .direction = direction}, Vec(mesh.positions[t.x]),
               Vec(mesh.positions[t.y]), Vec(mesh.positions[t.z]));
      if (hit && hit->t > 0.0L) {
        clear = clear && hit->to_edge > 1e-12L;
        winding += hit->entering ? -1 : 1;
      }
    }
    if (clear) {
      break;
    }
  }
  return winding > 0;
}

void add_surfaces(const MeshShape& shape, const Line& line, std::vector<Passage>& out) {
  const TriangleMesh& mesh = shape->mesh();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Vec a(mesh.positions[mesh.triangles[i].x]);
    const Vec b(mesh.positions[mesh.triangles[i].y]);
    const Vec c(mesh.positions[mesh.triangles[i].z]);
    if (const std::optional<TriangleHit> hit = meet(line, a, b, c)) {
      out.push_back(
          {.t = hit->t, .normal = glm::normalize(glm::cross(b - a, c - a)), .face = mesh.faces[i]});
    }
  }
}

}  // namespace

bool contains(const Shape& shape, const Vec& point) {
  return std::visit([&](const auto& s) { return inside(s, point); }, shape);
}

std::vector<Passage> passages(const Shape& shape, const Line& line) {
  std::vector<Passage> met;
  std::visit([&](const auto& s) { add_surfaces(s, line, met); }, shape);
  std::ranges::sort(met, {}, &Passage::t);
  std::vector<Passage> result;
  // Far before the first passage lies as good a point as any.
  const auto between = [&](std::size_t i) {
    if (i == 0) {
      return contains(shape, line.at(met.front().t - 1.0L));
    }
    return i == met.size() ? contains(shape, line.at(met.back().t + 1.0L))
                           : contains(shape, line.at((met[i - 1].t + met[i].t) / 2.0L));
  };
  bool before = !met.empty() && between(0);
  for (std::size_t i = 0; i < met.size(); ++i) {
    const bool after = between(i + 1);
    if (after != before) {
      result.push_back(met[i]);
    }
    before = after;
  }
  return result;
}

}  // namespace raycat::reference
