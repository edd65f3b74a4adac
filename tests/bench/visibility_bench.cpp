// What is seen first of a mesh of a million triangles, at 1024 x 1024: our closest hit and face
// id against a bare Embree loop, and against coherent packets, the limit to close in on.

#include <cstdlib>
#include <stdexcept>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "tests/bench/bare_embree.hpp"
#include "tests/bench/bumpy_sphere.hpp"
#include "tests/bench/cpu_clock.hpp"
#include "tests/bench/ratio_report.hpp"
#include "tracer/accel.hpp"

namespace raycat::bench {
namespace {

constexpr int image_side = 1024;

Scene scene_of(TriangleMesh triangles) {
  Scene scene;
  scene.materials.push_back({});
  scene.surfaces.add_object("ball");
  const SurfaceId first = scene.surfaces.add_primitive("ball", triangles.face_count);
  auto mesh = std::make_shared<SurfaceMesh>();
  mesh->triangles = std::move(triangles);
  scene.meshes.push_back({.mesh = std::move(mesh), .first_face = first});
  return scene;
}

void closest_hits(const Accel& accel, const ImagePlane& plane, int left, int top,
                  Solid::Scratch& scratch, SeenImage& out) {
  for (int y = top; y < top + tile; ++y) {
    for (int x = left; x < left + tile; ++x) {
      const std::optional<Hit> hit = accel.closest(plane.sample_ray(x, y), scratch);
      out.at(x, y) = hit ? Seen{.geometry = static_cast<std::uint32_t>(hit->surface),
                                .triangle = hit->triangle,
                                .t = hit->t}
                         : Seen{};
    }
  }
}

// CPU seconds of `work(left, top)` over one row of tiles.
template <typename Work>
double tile_row(int top, const Work& work) {
  return timed([&] {
    for (int left = 0; left < image_side; left += tile) {
      work(left, top);
    }
  });
}

// Both look at the same mesh, so nearly all pixels must show the same triangle; rays through
// edges may round to either side.
void require_same(const SeenImage& a, const SeenImage& b) {
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    differing += a.pixels[i].triangle != b.pixels[i].triangle;
  }
  if (differing * 1000 > a.pixels.size()) {
    throw std::runtime_error(
        fmt::format("{} of {} pixels show another triangle", differing, a.pixels.size()));
  }
}

void visibility(benchmark::State& state) {
  static const Scene scene = scene_of(bumpy_sphere(708, 708));
  static const Accel accel(scene);
  static const BareEmbree bare(scene.meshes.front().mesh->triangles);
  Camera camera = look_at({1.2, 0.9, 2.4}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
  const ImagePlane plane(camera, image_side, image_side);
  SeenImage ours(image_side, image_side);
  SeenImage single(image_side, image_side);
  SeenImage packets(image_side, image_side);
  Solid::Scratch scratch;
  for ([[maybe_unused]] auto _ : state) {
    double ours_seconds = 0.0;
    double bare_seconds = 0.0;
    double packet_seconds = 0.0;
    // One after the other on each row of tiles, so that the machine is the same for all three.
    for (int row = 0; row < image_side; row += tile) {
      ours_seconds += tile_row(
          row, [&](int left, int top) { closest_hits(accel, plane, left, top, scratch, ours); });
      bare_seconds +=
          tile_row(row, [&](int left, int top) { bare.single_rays(plane, left, top, single); });
      packet_seconds +=
          tile_row(row, [&](int left, int top) { bare.packets(plane, left, top, packets); });
    }
    state.counters["ours"] = ours_seconds;
    state.counters["bare"] = bare_seconds;
    state.counters["packets"] = packet_seconds;
  }
  require_same(ours, single);
  require_same(ours, packets);
}

BENCHMARK(visibility)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace raycat::bench

int main(int argc, char** argv) {
  return raycat::bench::run(
      argc, argv, {{"visibility", "ours", "bare", 1.3}, {"visibility", "ours", "packets", {}}});
}
