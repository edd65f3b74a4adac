// A .glb of a million triangles, with normals, from disk to the first ray: reading, welding,
// finding faces and building Embree's index, against reading the file's bytes and Embree's index
// alone.

#include <algorithm>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <malloc.h>

#include "io/files/input_file.hpp"
#include "io/load_scene.hpp"
#include "tests/bench/bare_embree.hpp"
#include "tests/bench/bumpy_sphere.hpp"
#include "tests/bench/cpu_clock.hpp"
#include "tests/bench/ratio_report.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tracer/accel.hpp"

namespace raycat::bench {
namespace {

template <typename T>
void append(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string glb(const TriangleMesh& mesh) {
  std::string binary;
  for (const glm::dvec3& position : mesh.positions) {
    append(binary, glm::vec3(position));
  }
  for (const glm::dvec3& position : mesh.positions) {
    append(binary, glm::vec3(glm::normalize(position)));
  }
  const std::size_t indices = binary.size();
  for (const glm::uvec3& triangle : mesh.triangles) {
    append(binary, triangle);
  }
  const std::size_t vectors = indices / 2;
  std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"NORMAL":1}},"indices":2}}]}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":{0},"type":"VEC3"}},
{{"bufferView":1,"componentType":5126,"count":{0},"type":"VEC3"}},
{{"bufferView":2,"componentType":5125,"count":{1},"type":"SCALAR"}}],
"bufferViews":[{{"buffer":0,"byteLength":{2}}},{{"buffer":0,"byteOffset":{2},"byteLength":{2}}},
{{"buffer":0,"byteOffset":{3},"byteLength":{4}}}],"buffers":[{{"byteLength":{5}}}]}})",
      mesh.positions.size(), 3 * mesh.triangles.size(), vectors, indices, binary.size() - indices,
      binary.size());
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string file = "glTF";
  append(file, std::uint32_t{2});
  append(file, static_cast<std::uint32_t>(28 + json.size() + binary.size()));
  append(file, static_cast<std::uint32_t>(json.size()));
  file += "JSON" + json;
  append(file, static_cast<std::uint32_t>(binary.size()));
  return file + std::string("BIN\0", 4) + binary;
}

// A line of /proc/self/status, in bytes.
double status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(key + ":")) {
      return 1024.0 * std::stod(line.substr(key.size() + 1));
    }
  }
  return 0.0;
}

// What `work` adds to the process at its peak.
template <typename Work>
double peak_bytes(const Work& work) {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";  // sets VmHWM back
  const double before = status_bytes("VmRSS");
  work();
  return status_bytes("VmHWM") - before;
}

void load(benchmark::State& state) {
  const TriangleMesh mesh = bumpy_sphere(1000, 500);
  const TemporaryFolder folder;
  const std::string file = folder.write("ball.glb", glb(mesh));
  const Ray ray{.origin = {0.0, 0.0, 5.0}, .direction = {0.0, 0.0, -1.0}};
  LoadOptions options;
  options.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const auto raycat = [&] {
    const SceneFile loaded = load_scene(file, options);
    const Accel accel(loaded.scene);
    Solid::Scratch scratch;
    benchmark::DoNotOptimize(accel.closest(ray, scratch));
  };
  const auto embree = [&] {
    benchmark::DoNotOptimize(read_bytes(file, std::uintmax_t{1} << 32));
    benchmark::DoNotOptimize(BareEmbree(mesh));
  };
  const std::size_t data =
      mesh.positions.size() * 2 * sizeof(glm::vec3) + mesh.triangles.size() * sizeof(glm::uvec3);
  for ([[maybe_unused]] auto _ : state) {
    state.counters["memory"] = peak_bytes(raycat);
    state.counters["data_and_bvh"] =
        2.5 * static_cast<double>(data) + static_cast<double>(BareEmbree(mesh).peak_bytes());
    state.counters["load"] =
        timed([&] { benchmark::DoNotOptimize(load_scene(file, options)); }, process_cpu_seconds);
    state.counters["raycat"] = timed(raycat, process_cpu_seconds);
    state.counters["embree"] = timed(embree, process_cpu_seconds);
    state.counters["raycat_wall"] = timed(raycat, wall_seconds);
    state.counters["embree_wall"] = timed(embree, wall_seconds);
  }
}

BENCHMARK(load)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace raycat::bench

int main(int argc, char** argv) {
  mallopt(M_MMAP_THRESHOLD, 1 << 20);  // as in app/main.cpp
  return raycat::bench::run(argc, argv,
                            {{"load", "raycat", "embree", 1.6},
                             {"load", "load", "embree", {}},
                             {"load", "memory", "data_and_bvh", 1.0},
                             {"load", "raycat_wall", "embree_wall", 1.6}});
}
