#include "categories/render.hpp"

#include <algorithm>
#include <mutex>
#include <optional>
#include <vector>

#include "tracer/parallel.hpp"

namespace raycat {
namespace {

// Reports rows as they are done; a worker that finds another one reporting goes on.
class Progress {
 public:
  Progress(const RenderSettings& settings, int rows) : report_(settings.progress), rows_(rows) {}

  void row_done() {
    const int done = ++done_;
    if (report_) {
      if (const std::unique_lock lock(mutex_, std::try_to_lock); lock || done == rows_) {
        report_(done, rows_);
      }
    }
  }

 private:
  const std::function<void(int, int)>& report_;
  int rows_;
  std::atomic<int> done_ = 0;
  std::mutex mutex_;
};

// Which primitives have a texture; empty if none has.
std::vector<bool> textured_primitives(const Scene& scene) {
  std::vector<bool> textured;
  for (const MeshInstance& instance : scene.meshes) {
    if (scene.materials[static_cast<std::size_t>(instance.material)].base_texture) {
      textured.resize(scene.surfaces.primitives());
      textured[static_cast<std::size_t>(scene.surfaces.primitive(instance.first_face))] = true;
    }
  }
  return textured;
}

// What one thread makes categories with.
struct Worker {
  TraceScratch scratch;
  RayTree tree;
  RayTree reduced;
  CategoryWords words;
  CategoryTable table;
  std::uint64_t textured_pixels = 0;

  // Of the sample before, which is most often alike.
  RayTree last_tree;
  std::optional<CategoryId> last;
};

bool same(const RayTree& a, const RayTree& b) {
  return std::ranges::equal(a, b, [](const RayNode& left, const RayNode& right) {
    return left == right && left.weight == right.weight;
  });
}

// The category, in the worker's own table, of the tree that it has recorded.
CategoryId category(Worker& worker, const Detail& detail, const SurfaceTable& surfaces,
                    const Encoder& encoder) {
  if (!worker.last || !same(worker.tree, worker.last_tree)) {
    worker.reduced = worker.tree;
    reduce(worker.reduced, detail, surfaces);
    encode(encoder, worker.reduced, worker.words);
    worker.last = worker.table.intern(worker.words);
    std::swap(worker.last_tree, worker.tree);
  }
  return *worker.last;
}

// Numbers the categories anew by first appearance in the image, whichever thread met them.
void number_in_order(CategoryImage& image, const std::vector<Worker>& workers,
                     const std::vector<int>& row_worker) {
  constexpr CategoryId unknown{~std::uint32_t{0}};
  std::vector<std::vector<CategoryId>> known;
  for (const Worker& worker : workers) {
    known.emplace_back(worker.table.size(), unknown);
  }
  const auto columns = static_cast<std::size_t>(image.width) + 1;
  std::size_t next = 0;
  for (const int worker : row_worker) {
    const auto w = static_cast<std::size_t>(worker);
    for (const std::size_t end = next + columns; next < end; ++next) {
      CategoryId& id = known[w][static_cast<std::size_t>(image.samples[next])];
      if (id == unknown) {
        id = image.table.intern(workers[w].table.words(image.samples[next]));
      }
      image.samples[next] = id;
    }
  }
}

}  // namespace

Extent extent(const Scene& scene, const Detail& detail, int levels) {
  return {.levels = static_cast<std::uint64_t>(std::min(levels, detail.levels)),
          .lights = detail.lights ? scene.lights.size() : 0,
          .surfaces = scene.surfaces.count(detail.ids)};
}

Rendering render(const Accel& accel, const Camera& camera, const RenderSettings& settings) {
  const int columns = settings.width + 1;
  const int rows = settings.height + 1;
  const Scene& scene = accel.scene();
  Rendering result{.colour = Image(settings.width, settings.height),
                   .extent = extent(scene, settings.detail, settings.levels)};
  const Encoder encoder = heap_encoder(result.extent);
  const ImagePlane plane(camera, settings.width, settings.height);
  const std::vector<bool> textured = textured_primitives(scene);

  CategoryImage& categories = result.categories;
  categories.width = settings.width;
  categories.height = settings.height;
  categories.samples.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  std::vector<Worker> workers(static_cast<std::size_t>(settings.threads));
  std::vector<int> row_worker(static_cast<std::size_t>(rows));
  Progress progress(settings, rows);

  parallel_rows(rows, settings.threads, [&](int y, int w) {
    Worker& worker = workers[static_cast<std::size_t>(w)];
    row_worker[static_cast<std::size_t>(y)] = w;
    for (int x = 0; x < columns; ++x) {
      worker.tree.clear();
      const glm::vec3 colour =
          trace(accel, plane.ray(x + 0.5, y + 0.5), settings.levels, worker.tree, worker.scratch);
      const bool pixel = x < settings.width && y < settings.height;
      if (pixel) {
        result.colour.pixels[result.colour.index(x, y)] = colour;
      }
      if (pixel && !textured.empty()) {
        worker.textured_pixels += std::ranges::any_of(worker.tree, [&](const RayNode& node) {
          return textured[static_cast<std::size_t>(scene.surfaces.primitive(node.surface))];
        });
      }
      categories.samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                         static_cast<std::size_t>(x)] =
          category(worker, settings.detail, scene.surfaces, encoder);
    }
    progress.row_done();
  });

  number_in_order(categories, workers, row_worker);
  for (const Worker& worker : workers) {
    result.rays += worker.scratch.rays;
    result.textured_pixels += worker.textured_pixels;
  }
  return result;
}

Image render_colour(const Accel& accel, const Camera& camera, const RenderSettings& settings,
                    RayCounts& rays) {
  Image image(settings.width, settings.height);
  const ImagePlane plane(camera, settings.width, settings.height);
  std::vector<TraceScratch> scratch(static_cast<std::size_t>(settings.threads));
  Progress progress(settings, settings.height);
  parallel_rows(settings.height, settings.threads, [&](int y, int w) {
    NoRecord nothing;
    for (int x = 0; x < settings.width; ++x) {
      image.pixels[image.index(x, y)] = trace(accel, plane.ray(x + 0.5, y + 0.5), settings.levels,
                                              nothing, scratch[static_cast<std::size_t>(w)]);
    }
    progress.row_done();
  });
  for (const TraceScratch& each : scratch) {
    rays += each.rays;
  }
  return image;
}

}  // namespace raycat
