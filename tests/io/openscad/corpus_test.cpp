#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "geometry/mesh.hpp"
#include "io/load_scene.hpp"
#include "io/meshes/mesh_file.hpp"
#include "tests/io/scene_text.hpp"
#include "tests/support/sanitized.hpp"

namespace raycat {
namespace {

// What the line is inside of, ascending and apart.
using Intervals = std::vector<std::pair<double, double>>;

Intervals united(Intervals all, double tolerance) {
  std::ranges::sort(all);
  Intervals out;
  for (const auto& [begin, end] : all) {
    if (!out.empty() && begin <= out.back().second + tolerance) {
      out.back().second = std::max(out.back().second, end);
    } else {
      out.emplace_back(begin, end);
    }
  }
  std::erase_if(out, [&](const auto& i) { return i.second - i.first <= tolerance; });
  return out;
}

Intervals inside(const Scene& scene, const Ray& ray, double tolerance) {
  static Solid::Scratch scratch;
  Intervals out;
  for (const SolidObject& object : scene.solids) {
    CHECK_FALSE(object.solid.cross(ray, scratch));
    REQUIRE(scratch.boundaries.size() % 2 == 0);
    for (std::size_t i = 0; i < scratch.boundaries.size(); i += 2) {
      out.emplace_back(scratch.boundaries[i].t, scratch.boundaries[i + 1].t);
    }
  }
  return united(std::move(out), tolerance);
}

Intervals inside(const ClosedMesh& mesh, const Ray& ray, double tolerance) {
  Crossings crossings;
  mesh.cross(ray, crossings);
  Intervals out;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    out.emplace_back(crossings[i].t, crossings[i + 1].t);
  }
  return united(std::move(out), tolerance);
}

double thickness(const Intervals& intervals) {
  double sum = 0.0;
  for (const auto& [begin, end] : intervals) {
    sum += end - begin;
  }
  return sum;
}

bool agree(const Intervals& a, const Intervals& b, double tolerance) {
  const bool first_agrees =
      a.empty() == b.empty() && (a.empty() || std::abs(a[0].first - b[0].first) <= tolerance);
  const auto pieces = static_cast<double>(std::max({a.size(), b.size(), std::size_t{1}}));
  return first_agrees && std::abs(thickness(a) - thickness(b)) <= tolerance * pieces;
}

struct Comparison {
  int rays = 0;
  int bad = 0;
};

// Rays of a grid along each axis. The grid is a little off, so that no ray runs in a face.
Comparison compare(const Scene& scene, const ClosedMesh& reference) {
#ifdef NDEBUG
  constexpr int side = 100;
#else
  constexpr int side = 30;
#endif
  const Bounds box = reference.bounds();
  const double half_diagonal = glm::length(box.half_size());
  const double tolerance = 1e-4 * half_diagonal;
  Comparison out;
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
        if (!agree(inside(scene, ray, tolerance), inside(reference, ray, tolerance), tolerance)) {
          ++out.bad;
        }
      }
    }
  }
  return out;
}

std::vector<std::filesystem::path> csg_files() {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(corpus() / "csg")) {
    for (const auto& entry : std::filesystem::directory_iterator(corpus() / "csg")) {
      if (entry.path().extension() == ".csg") {
        files.push_back(entry.path());
      }
    }
  }
  std::ranges::sort(files);
  return files;
}

TEST_CASE("real .csg files are the solids that OpenSCAD evaluates them to", "[io][openscad]") {
  const std::vector<std::filesystem::path> files = csg_files();
  if (files.empty()) {
    WARN("skipped: no corpus");
    return;
  }
  for (const std::filesystem::path& file : files) {
    INFO(file.filename());
    if (sanitized && file.filename().string().starts_with("minkowski3-difference")) {
      WARN("left out of a sanitizer's build for its time: " << file.filename());
      continue;
    }
    const SceneFile scene = load_scene(file);
    std::filesystem::path stl = file;
    TriangleMesh mesh = read_mesh_file(stl.replace_extension(".stl"), SceneKind::stl).triangles;
    mesh.faces.assign(mesh.triangles.size(), 0);
    mesh.face_count = 1;
    const ClosedMesh reference(std::move(mesh));
    const Comparison result = compare(scene.scene, reference);
    WARN(fmt::format("{}: {} objects, {} rays, {} bad", file.filename().string(),
                     scene.scene.surfaces.objects(), result.rays, result.bad));
    CHECK(result.bad == 0);
  }
}

}  // namespace
}  // namespace raycat
