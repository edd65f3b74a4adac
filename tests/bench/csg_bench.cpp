// Rays through CSG trees of 100 to 100 000 leaves, in three forms of the same set; stacks of
// plates, of which the first decides; and a plate with 400 drilled holes against POV-Ray on the
// same scene.

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <malloc.h>

#include "csg/solid.hpp"
#include "render/render.hpp"
#include "tests/bench/cpu_clock.hpp"
#include "tests/bench/povray_time.hpp"
#include "tests/bench/ratio_report.hpp"

namespace raycat::bench {
namespace {

using NodeId = CsgTree::NodeId;

constexpr int layers = 8;
constexpr int rays = 20'000;

enum class Form { left, balanced, flat };

NodeId add(CsgTree& tree, const Shape& shape, const glm::dvec3& at, std::uint32_t& face) {
  PlacedShape placed(shape, Affine(glm::translate(glm::dmat4(1.0), at)));
  const SurfaceId first{face};
  face += placed.face_count();
  return tree.add({.shape = std::move(placed), .first_face = first});
}

// Unites neighbours until one is left.
NodeId united(CsgTree& tree, std::vector<NodeId> nodes) {
  while (nodes.size() > 1) {
    std::vector<NodeId> above;
    for (std::size_t i = 0; i + 1 < nodes.size(); i += 2) {
      above.push_back(tree.add(Operation::set_union, std::array{nodes[i], nodes[i + 1]}));
    }
    if (nodes.size() % 2 == 1) {
      above.push_back(nodes.back());
    }
    nodes = std::move(above);
  }
  return nodes.front();
}

// How many cells a block of eight layers has along each side, for about `leaves` leaves.
int side_for(int leaves) {
  return static_cast<int>(std::lround(std::sqrt(leaves / double{layers})));
}

// A block of unit cells with a ball cut out of each.
Solid sponge(int leaves, Form form) {
  const int side = side_for(leaves);
  CsgTree tree;
  std::uint32_t face = 0;
  NodeId node =
      add(tree, Box{.size = {side, side, layers}}, 0.5 * glm::dvec3(side, side, layers), face);
  std::vector<NodeId> balls;
  for (int i = 0; i < side * side * layers; ++i) {
    const glm::dvec3 cell(i / layers % side, i / layers / side, i % layers);
    const NodeId ball = add(tree, Sphere{.radius = 0.4}, cell + 0.5, face);
    if (form == Form::left) {
      node = tree.add(Operation::difference, std::array{node, ball});
    } else {
      balls.push_back(ball);
    }
  }
  if (form == Form::balanced) {
    tree.add(Operation::difference, std::array{node, united(tree, std::move(balls))});
  } else if (form == Form::flat) {
    balls.insert(balls.begin(), node);
    tree.add(Operation::difference, balls);
  }
  return Solid(std::move(tree));
}

// CPU seconds of rays through all layers, which cross the same number of balls at any size.
double seconds(const Solid& solid, int leaves) {
  const double side = side_for(leaves);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.0, side);
  Solid::Scratch scratch;
  std::size_t boundaries = 0;
  const auto trace = [&](int count) {
    for (int i = 0; i < count; ++i) {
      const glm::dvec3 origin(place(random), place(random), -1.0);
      solid.cross({.origin = origin, .direction = {0.001, 0.002, 1.0}}, scratch);
      boundaries += scratch.boundaries.size();
    }
  };
  trace(rays / 10);  // the scratch grows
  const double taken = timed([&] { trace(rays); });
  benchmark::DoNotOptimize(boundaries);
  return taken;
}

std::size_t memory_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

// Built once and kept: building is no part of what is measured.
const Solid& built(int leaves, Form form) {
  static std::map<std::pair<int, Form>, std::unique_ptr<Solid>> solids;
  auto& solid = solids[{leaves, form}];
  if (!solid) {
    const std::size_t before = memory_in_use();
    solid = std::make_unique<Solid>(sponge(leaves, form));
    constexpr std::array names{"left-deep", "balanced", "flat"};
    fmt::print("memory of a leaf: {} of {}, {} bytes\n", names[static_cast<std::size_t>(form)],
               solid->tree().leaves().size(),
               (memory_in_use() - before) / solid->tree().leaves().size());
  }
  return *solid;
}

void forms(benchmark::State& state, int leaves) {
  for ([[maybe_unused]] auto _ : state) {
    state.counters["left"] = seconds(built(leaves, Form::left), leaves);
    state.counters["balanced"] = seconds(built(leaves, Form::balanced), leaves);
    state.counters["flat"] = seconds(built(leaves, Form::flat), leaves);
  }
}

void growth(benchmark::State& state, Form form) {
  for ([[maybe_unused]] auto _ : state) {
    state.counters["hundred"] = seconds(built(100, form), 100);
    state.counters["thousand"] = seconds(built(1'000, form), 1'000);
    state.counters["tenthousand"] = seconds(built(10'000, form), 10'000);
    state.counters["most"] = seconds(built(100'000, form), 100'000);
  }
}

// Plates one behind the other, of which the first two let light through.
Scene stack(int plates) {
  Scene scene;
  scene.surfaces.add_object("stack");
  CsgTree tree;
  std::vector<NodeId> operands;
  std::uint32_t face = 0;
  for (int i = 0; i < plates; ++i) {
    operands.push_back(add(tree, Box{.size = {1, 1, 0.5}}, {0, 0, i}, face));
    scene.surfaces.add_primitive("plate", 6);
  }
  tree.add(Operation::set_union, operands);
  std::vector<MaterialId> materials(operands.size(), MaterialId{1});
  materials[0] = materials[1] = MaterialId{0};
  scene.materials = {{.transmission = glm::vec3(0.5f)}, {}};
  scene.solids.push_back({.solid = Solid(std::move(tree)), .materials = std::move(materials)});
  return scene;
}

// What is behind what decides should cost nothing.
void early_exit(benchmark::State& state) {
  constexpr int few = 100;
  constexpr int many = 10'000;
  const Scene shallow = stack(few);
  const Scene deep = stack(many);
  Solid::Scratch scratch;
  double sum = 0.0;
  const auto each_ray = [&](int count, const auto& trace) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-0.4, 0.4);
    return timed([&] {
      for (int i = 0; i < count; ++i) {
        const Ray ray{.origin = {place(random), place(random), -5.0}, .direction = {0, 0, 1}};
        trace(ray);
      }
    });
  };
  const auto first = [&](const Scene& scene) {
    const Solid& solid = scene.solids.front().solid;
    return each_ray(rays, [&](const Ray& ray) { sum += solid.first(ray, 0, 1e9, scratch)->t; });
  };
  const auto shadow = [&](const Scene& scene) {
    const Accel accel(scene);
    return each_ray(rays, [&](const Ray& ray) { sum += accel.transmittance(ray, 1e9, scratch).x; });
  };
  for ([[maybe_unused]] auto _ : state) {
    const Solid& solid = shallow.solids.front().solid;
    state.counters["all"] = each_ray(rays, [&](const Ray& ray) {
      solid.cross(ray, scratch);
      sum += scratch.boundaries.back().t;
    });
    state.counters["firstdeep"] = first(deep);
    state.counters["first"] = first(shallow);
    state.counters["shadowdeep"] = shadow(deep);
    state.counters["shadow"] = shadow(shallow);
  }
  benchmark::DoNotOptimize(sum);
}

// As in holes.pov.
Scene drilled_plate() {
  Scene scene;
  scene.surfaces.add_object("plate");
  CsgTree tree;
  std::vector<NodeId> operands;
  const auto operand = [&](const std::string& name, const Shape& shape, const glm::dvec3& at) {
    PlacedShape placed(shape, Affine(glm::translate(glm::dmat4(1.0), at)));
    const SurfaceId first = scene.surfaces.add_primitive(name, placed.face_count());
    operands.push_back(tree.add({.shape = std::move(placed), .first_face = first}));
  };
  operand("plate", Box{.size = {20, 1, 20}}, {0, 0, 0});
  for (int i = 0; i < 400; ++i) {
    operand(fmt::format("hole {}", i),
            Cylinder{.height = 2, .radius_top = 0.35, .radius_bottom = 0.35},
            {i / 20 - 9.5, 0, i % 20 - 9.5});
  }
  tree.add(Operation::difference, operands);
  scene.solids.push_back(
      {.solid = Solid(std::move(tree)), .materials = std::vector<MaterialId>(operands.size())});
  scene.materials.push_back(
      {.ambient = glm::vec3(0.5f, 0.6f, 0.7f), .diffuse = glm::vec3(0.5f, 0.6f, 0.7f)});
  scene.lights.push_back({.position = {-20, 40, 15}});
  Camera camera = look_at({9, 22, 27}, {0, 0, 0}, {0, 1, 0});
  camera.half_height = std::tan(0.3);
  scene.cameras.push_back(camera);
  return scene;
}

void holes(benchmark::State& state) {
  constexpr int side = 512;
  const Scene scene = drilled_plate();
  const Accel accel(scene);
  const RenderSettings settings{.width = side, .height = side};
  for ([[maybe_unused]] auto _ : state) {
    const std::optional<double> povray = povray_trace_seconds(RAYCAT_BENCH "/holes.pov", side);
    if (!povray) {
      state.SkipWithError("povray does not trace holes.pov");
      break;
    }
    state.counters["povray"] = *povray;
    state.counters["heap"] =
        timed([&] { benchmark::DoNotOptimize(render(accel, scene.cameras.front(), settings)); });
  }
}

BENCHMARK_CAPTURE(forms, tenthousand, 10'000)->Name("forms")->Iterations(1);
BENCHMARK_CAPTURE(growth, left, Form::left)->Name("growthleft")->Iterations(1);
BENCHMARK_CAPTURE(growth, balanced, Form::balanced)->Name("growthbalanced")->Iterations(1);
BENCHMARK_CAPTURE(growth, flat, Form::flat)->Name("growthflat")->Iterations(1);
BENCHMARK(early_exit)->Name("stack")->Iterations(1);

}  // namespace
}  // namespace raycat::bench

int main(int argc, char** argv) {
  using namespace raycat::bench;
  constexpr double log_growth = 2.5;  // log 100 000 / log 100
  std::vector<Ratio> ratios{{"forms", "left", "balanced", 1.5}, {"forms", "flat", "balanced", {}}};
  for (const char* name : {"growthleft", "growthbalanced", "growthflat"}) {
    ratios.push_back({name, "thousand", "hundred", 1.5});
    ratios.push_back({name, "tenthousand", "hundred", 2.0});
    ratios.push_back({name, "most", "hundred", log_growth});
  }
  // log 10 000 / log 100; one of 200 crossings.
  ratios.push_back({"stack", "firstdeep", "first", 2.0});
  ratios.push_back({"stack", "shadowdeep", "shadow", 2.0});
  ratios.push_back({"stack", "first", "all", 0.1});
  if (povray_present()) {
    benchmark::RegisterBenchmark("holes", holes)->Iterations(1);
    ratios.push_back({"holes", "heap", "povray", 0.1});
  } else {
    fmt::print("povray is not installed: holes skipped\n");
  }
  return run(argc, argv, ratios);
}
