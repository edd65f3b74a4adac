// more SCENE NAME: what docs/adopting.md shows past the 40 lines. Says whether several threads,
// each with a table of its own, make the categories that one makes, and draws the edges of these
// without lights and past the second level into NAME-outlines.pgm.

#define main spheres_main
#include "spheres_raycat.cpp"
#undef main

#include <string>
#include <thread>

#include <raycat/categories/recode.hpp>

struct Worker {
  Tracer tracer;
  raycat::CategoryTable table;
};

// Rows are dealt out in turn; `samples` are numbered in the table of the row's worker.
void sample_rows(Worker& worker, std::size_t first, std::size_t step,
                 const raycat::Encoder& encoder, std::vector<raycat::CategoryId>& samples) {
  raycat::CategoryWords words;
  for (std::size_t y = first; y <= height; y += step) {
    for (std::size_t x = 0; x <= width; ++x) {
      const double right = (2 * (static_cast<double>(x) + 0.5) - width) / height;
      const double up = 1 - 2 * (static_cast<double>(y) + 0.5) / height;
      worker.tracer.look({0, 0, 0}, unit({right, up - 0.9, -3.2}));
      raycat::encode(encoder, worker.tracer.tree, words);
      samples[y * (width + 1) + x] = worker.table.intern(words);
    }
  }
}

raycat::Encoder heap(const Tracer& tracer) {
  return raycat::make_encoder(
      raycat::Method::heap,
      {.levels = deepest, .lights = tracer.lamps.size(), .surfaces = tracer.balls.size()});
}

raycat::CategoryImage categorize(const Tracer& tracer, std::size_t threads) {
  const raycat::Encoder encoder = heap(tracer);
  raycat::CategoryImage categories;
  categories.width = width;
  categories.height = height;
  categories.encoder = encoder;
  categories.samples.resize((width + 1) * (height + 1));
  std::vector<Worker> workers(threads, Worker{tracer, {}});
  std::vector<std::thread> running;
  for (std::size_t i = 0; i < threads; ++i) {
    running.emplace_back(
        [&, i] { sample_rows(workers[i], i, threads, encoder, categories.samples); });
  }
  for (std::thread& thread : running) {
    thread.join();
  }

  for (std::size_t i = 0; i < categories.samples.size(); ++i) {
    const Worker& worker = workers[i / (width + 1) % threads];  // that sampled the row
    raycat::CategoryId& sample = categories.samples[i];
    sample = categories.table.intern(worker.table.words(sample));
  }
  return categories;
}

bool same(const raycat::CategoryImage& a, const raycat::CategoryImage& b) {
  bool same = a.samples == b.samples && a.table.size() == b.table.size();
  for (std::uint32_t id = 0; same && id < a.table.size(); ++id) {
    same = std::ranges::equal(a.table.words(raycat::CategoryId{id}),
                              b.table.words(raycat::CategoryId{id}));
  }
  return same;
}

raycat::CategoryImage outlines(const Tracer& tracer, const raycat::CategoryImage& categories) {
  raycat::SurfaceTable surfaces;
  for (std::size_t i = 0; i < tracer.balls.size(); ++i) {
    surfaces.add_object("ball " + std::to_string(i));
    surfaces.add_primitive("ball", 1);
  }
  const raycat::Detail detail{.levels = 2, .lights = false};
  const raycat::Encoder encoder = raycat::make_encoder(
      raycat::Method::heap, {.levels = 2, .lights = 0, .surfaces = surfaces.faces()});
  raycat::CategoryTrees trees(categories);
  return raycat::recode(trees, detail, surfaces, encoder);
}

int main(int argc, char** argv) {
  Tracer tracer;
  std::ifstream scene(argc == 3 ? argv[1] : "");
  if (!tracer.read(scene)) {
    std::fputs("usage: more SCENE NAME\n", stderr);
    return 2;
  }
  const raycat::CategoryImage one = categorize(tracer, 1);
  const raycat::CategoryImage many = categorize(tracer, 5);
  const raycat::CategoryImage fewer = outlines(tracer, one);
  std::printf("%zu categories, %zu of outlines\n", one.table.size(), fewer.table.size());

  std::ofstream map(std::string(argv[2]) + "-outlines.pgm", std::ios::binary);
  map << "P5\n" << width << ' ' << height << "\n255\n";
  for (const std::uint8_t edge : raycat::detect_edges(fewer).pixels) {
    map.put(static_cast<char>(edge != 0 ? 0 : 255));
  }
  if (!same(one, many)) {
    std::fputs("more: the categories depend on the number of threads\n", stderr);
    return 1;
  }
  return map.flush() ? 0 : 1;
}
