#include "tests/modelling/openscad_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "tests/support/temporary_folder.hpp"

namespace raycat {
namespace {

// Where the line is inside, ascending and apart.
using Intervals = std::vector<std::pair<double, double>>;

Intervals inside(const ClosedMesh& mesh, const Ray& ray, double tolerance) {
  Crossings crossings;
  mesh.cross(ray, crossings);
  Intervals out;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    if (!out.empty() && crossings[i].t <= out.back().second + tolerance) {
      out.back().second = std::max(out.back().second, crossings[i + 1].t);
    } else {
      out.emplace_back(crossings[i].t, crossings[i + 1].t);
    }
  }
  std::erase_if(out, [&](const auto& i) { return i.second - i.first <= tolerance; });
  return out;
}

// What the values on several lines lie between.
struct Span {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  void include(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  bool holds(double value, double tolerance) const {
    return value >= least - tolerance && value <= most + tolerance;
  }
};

double thickness(const Intervals& intervals) {
  double sum = 0.0;
  for (const auto& [begin, end] : intervals) {
    sum += end - begin;
  }
  return sum;
}

// Where the line grazes an edge, a small difference across it is a large one along it. So what
// the reference has must lie between what this line and those beside it have.
bool agree(const ClosedMesh& mesh, const ClosedMesh& reference, const Ray& ray, double tolerance) {
  const Intervals expected = inside(reference, ray, tolerance);
  Span thick;
  Span first;
  bool misses = false;
  for (int side = -1; side < 6; ++side) {
    Ray beside = ray;
    if (side >= 0) {
      beside.origin[side / 2] += (side % 2 == 0 ? 0.5 : -0.5) * tolerance;
    }
    const Intervals found = inside(mesh, beside, tolerance);
    misses = misses || found.empty();
    thick.include(thickness(found));
    if (!found.empty()) {
      first.include(found[0].first);
    }
  }
  const auto pieces = static_cast<double>(std::max(expected.size(), std::size_t{1}));
  return thick.holds(thickness(expected), tolerance * pieces) &&
         (expected.empty() ? misses : first.holds(expected[0].first, tolerance));
}

}  // namespace

bool openscad_is_installed() {
  static const bool found = std::system("command -v openscad >/dev/null 2>&1") == 0;
  if (!found) {
    WARN("skipped: no openscad");
  }
  return found;
}

TriangleMesh openscad_mesh(const std::string& csg) {
  const TemporaryFolder folder;
  const std::string in = folder / "in.csg";
  const std::string out = folder / "out.stl";
  std::ofstream(in) << csg;
  const std::string command = fmt::format("openscad -o '{}' '{}' >/dev/null 2>&1", out, in);
  if (std::system(command.c_str()) != 0) {
    throw std::runtime_error("openscad makes nothing of " + csg);
  }
  TriangleMesh mesh;
  std::ifstream stl(out);
  for (std::string word; stl >> word;) {
    if (word == "vertex") {
      glm::dvec3 p;
      stl >> p.x >> p.y >> p.z;
      mesh.positions.push_back(p);
    }
  }
  for (std::uint32_t i = 0; i + 2 < mesh.positions.size(); i += 3) {
    mesh.triangles.emplace_back(i, i + 1, i + 2);
  }
  mesh.faces.assign(mesh.triangles.size(), 0);
  mesh.face_count = 1;
  return mesh;
}

// The grid is a little off, so that no ray runs in a face.
RayComparison compare(const ClosedMesh& mesh, const ClosedMesh& reference) {
  constexpr int side = 40;
  const Bounds box = reference.bounds();
  const double half_diagonal = glm::length(box.half_size());
  const double tolerance = 1e-4 * half_diagonal;
  RayComparison out;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        Ray ray{.origin = box.min, .direction = glm::dvec3(0.0)};
        ray.direction[axis] = 1.0;
        ray.origin[axis] -= half_diagonal;
        ray.origin[u] += (i + 0.4871) / side * (box.max[u] - box.min[u]);
        ray.origin[v] += (j + 0.5237) / side * (box.max[v] - box.min[v]);
        ++out.rays;
        if (!agree(mesh, reference, ray, tolerance)) {
          ++out.bad;
        }
      }
    }
  }
  return out;
}

double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    sum += glm::dot(mesh.positions[t.x], glm::cross(mesh.positions[t.y], mesh.positions[t.z]));
  }
  return sum / 6.0;
}

}  // namespace raycat
