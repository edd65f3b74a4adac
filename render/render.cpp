#include "render/render.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "render/repeat_recorder.hpp"
#include "render/scene_sampler.hpp"
#include "render/textured_primitives.hpp"
#include "threads/parallel.hpp"
#include "threads/row_progress.hpp"

namespace raycat {
namespace {

// What is the same for all samples of an image.
struct Plan {
  const Accel& accel;
  const RenderSettings& settings;
  const Encoder& encoder;
  std::vector<bool> textured;  // by primitive; empty if nothing is to be marked

  Plan(const Accel& accel_in, const RenderSettings& settings_in, const Encoder& encoder_in)
      : accel(accel_in), settings(settings_in), encoder(encoder_in) {
    if (settings.mark_textures) {
      textured = textured_primitives(accel.scene());
    }
  }
};

struct Sample {
  glm::vec3 colour;
  CategoryId category;  // in the worker's own table
  bool textured;
  bool repeats;  // is the tree that of the worker's sample before?
};

// Makes categories on one thread.
class Worker {
 public:
  Sample sample(const Plan& plan, const Ray& ray) {
    recorder_.start();
    const glm::vec3 colour = trace(plan.accel, ray, plan.settings.levels, recorder_, scratch_);
    const bool repeats = recorder_.repeats() && known_;
    if (!repeats) {
      categorize(plan);
    }
    return {.colour = colour, .category = category_, .textured = textured_, .repeats = repeats};
  }

  // Of the last sample.
  const RayTree& tree() const { return recorder_.tree(); }

  const CategoryTable& table() const { return table_; }
  const RayCounts& rays() const { return scratch_.rays; }

 private:
  void categorize(const Plan& plan) {
    const SurfaceTable& surfaces = plan.accel.scene().surfaces;
    reduced_ = recorder_.tree();
    reduce(reduced_, plan.settings.detail, surfaces);
    encode(plan.encoder, reduced_, words_);
    category_ = table_.intern(words_);
    textured_ =
        !plan.textured.empty() && std::ranges::any_of(recorder_.tree(), [&](const RayNode& node) {
          return plan.textured[static_cast<std::size_t>(surfaces.primitive(node.surface))];
        });
    known_ = true;
  }

  TraceScratch scratch_;
  RepeatRecorder recorder_;
  RayTree reduced_;
  CategoryWords words_;
  CategoryTable table_;

  // Of the recorder's tree, once there is one.
  bool known_ = false;
  CategoryId category_{};
  bool textured_ = false;
};

// Numbers the categories of `samples` anew in `table` by first appearance, whichever thread met
// them: `worker_of[i]` made the i-th run of `run` samples.
void number_in_order(std::span<CategoryId> samples, std::size_t run,
                     const std::vector<Worker>& workers, const std::vector<int>& worker_of,
                     CategoryTable& table) {
  constexpr CategoryId unknown{~std::uint32_t{0}};
  std::vector<std::vector<CategoryId>> known;
  for (const Worker& worker : workers) {
    known.emplace_back(worker.table().size(), unknown);
  }
  std::size_t next = 0;
  for (const int worker : worker_of) {
    const auto w = static_cast<std::size_t>(worker);
    for (const std::size_t end = std::min(next + run, samples.size()); next < end; ++next) {
      CategoryId& id = known[w][static_cast<std::size_t>(samples[next])];
      if (id == unknown) {
        id = table.intern(workers[w].table().words(samples[next]));
      }
      samples[next] = id;
    }
  }
}

void require(const RenderSettings& settings) {
  if (settings.width < 1 || settings.height < 1 || settings.threads < 1 || settings.levels < 1 ||
      settings.levels > most_levels) {
    throw std::invalid_argument(fmt::format(
        "a picture has at least 1x1 pixels, 1 thread, and 1 to {} levels, but {}x{} "
        "pixels, {} threads and {} levels are asked for",
        most_levels, settings.width, settings.height, settings.threads, settings.levels));
  }
}

}  // namespace

Extent extent(const Scene& scene, const Detail& detail, int levels) {
  return {.levels = static_cast<std::uint64_t>(std::min(levels, detail.levels)),
          .lights = detail.lights ? scene.lights.size() : 0,
          .surfaces = scene.surfaces.count(detail.ids) + (detail.paths ? 1 : 0)};
}

namespace {

Rendering render_samples(const Accel& accel, const Camera& camera, const RenderSettings& settings,
                         SceneSampler* keeper) {
  require(settings);
  const int columns = settings.width + 1;
  const int rows = settings.height + 1;
  Rendering result{.colour = Image(settings.width, settings.height)};
  const ImagePlane plane(camera, settings.width, settings.height);

  CategoryImage& categories = result.categories;
  categories.width = settings.width;
  categories.height = settings.height;
  categories.detail = settings.detail;
  categories.encoder =
      make_encoder(settings.method, extent(accel.scene(), settings.detail, settings.levels));
  const Plan plan(accel, settings, *categories.encoder);
  categories.samples.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  categories.textured.resize(plan.textured.empty() ? 0 : categories.samples.size());
  std::vector<Worker> workers(static_cast<std::size_t>(settings.threads));
  std::vector<int> row_worker(static_cast<std::size_t>(rows));
  RowProgress progress(settings.progress, rows);

  parallel_rows(rows, settings.threads, [&](int y, int w) {
    Worker& worker = workers[static_cast<std::size_t>(w)];
    row_worker[static_cast<std::size_t>(y)] = w;
    std::size_t next = static_cast<std::size_t>(y) * static_cast<std::size_t>(columns);
    for (int x = 0; x < columns; ++x, ++next) {
      const Sample sample = worker.sample(plan, plane.sample_ray(x, y));
      if (x < settings.width && y < settings.height) {
        result.colour.pixels[result.colour.index(x, y)] = sample.colour;
      }
      categories.samples[next] = sample.category;
      if (keeper != nullptr) {
        keeper->keep(next, sample.colour, worker.tree(), sample.repeats, w);
      }
      if (sample.textured) {
        categories.textured[next] = 1;
      }
    }
    progress.row_done();
  });

  number_in_order(categories.samples, static_cast<std::size_t>(columns), workers, row_worker,
                  categories.table);
  for (const Worker& worker : workers) {
    result.rays += worker.rays();
  }
  return result;
}

}  // namespace

Rendering render(const Accel& accel, const Camera& camera, const RenderSettings& settings) {
  return render_samples(accel, camera, settings, nullptr);
}

Rendering render(const Accel& accel, const Camera& camera, const RenderSettings& settings,
                 SceneSampler& keeper) {
  return render_samples(accel, camera, settings, &keeper);
}

Image render_colour(const Accel& accel, const Camera& camera, const RenderSettings& settings,
                    RayCounts& rays) {
  Image image(settings.width, settings.height);
  const ImagePlane plane(camera, settings.width, settings.height);
  std::vector<TraceScratch> scratch(static_cast<std::size_t>(settings.threads));
  RowProgress progress(settings.progress, settings.height);
  parallel_rows(settings.height, settings.threads, [&](int y, int w) {
    NoRecord nothing;
    for (int x = 0; x < settings.width; ++x) {
      image.pixels[image.index(x, y)] = trace(accel, plane.sample_ray(x, y), settings.levels,
                                              nothing, scratch[static_cast<std::size_t>(w)]);
    }
    progress.row_done();
  });
  for (const TraceScratch& each : scratch) {
    rays += each.rays;
  }
  return image;
}

std::vector<CategoryId> FinerSamples::operator()(std::span<const glm::dvec2> points) {
  constexpr std::size_t run = 256;
  const Plan plan(accel_, settings_, encoder_);
  const ImagePlane plane(camera_, settings_.width, settings_.height);
  const std::size_t runs = (points.size() + run - 1) / run;
  std::vector<CategoryId> samples(points.size());
  std::vector<Worker> workers(static_cast<std::size_t>(settings_.threads));
  std::vector<int> run_worker(runs);
  parallel_rows(static_cast<int>(runs), settings_.threads, [&](int r, int w) {
    run_worker[static_cast<std::size_t>(r)] = w;
    const std::size_t begin = static_cast<std::size_t>(r) * run;
    for (std::size_t i = begin; i < std::min(begin + run, points.size()); ++i) {
      samples[i] = workers[static_cast<std::size_t>(w)]
                       .sample(plan, plane.sample_ray(points[i].x, points[i].y))
                       .category;
    }
  });
  number_in_order(samples, run, workers, run_worker, table_);
  for (const Worker& worker : workers) {
    rays_ += worker.rays();
  }
  return samples;
}

}  // namespace raycat
