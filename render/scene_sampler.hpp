#pragma once

#include <vector>

#include "antialias/sampler.hpp"
#include "render/render.hpp"
#include "render/repeat_recorder.hpp"
#include "render/tree_table.hpp"
#include "tracer/camera.hpp"
#include "tracer/tracer.hpp"

namespace raycat {

/// Is what rays that leave the scene at once see part of the picture, or transparent?
enum class Backdrop { shown, transparent };

/// Samples a scene through a camera. Categories are those of whole trees.
class SceneSampler : public Sampler {
 public:
  /// Keeps a reference to the accelerator. With `keeps` there is room for the samples of `render`.
  SceneSampler(const Accel& accel, const Camera& camera, int width, int height, int levels,
               int threads, Backdrop backdrop = Backdrop::shown, bool keeps = false);

  ColourSample sample(const glm::dvec2& point, int worker) override;
  std::optional<TreeId> side(const glm::dvec2& point, TreeId a, TreeId b, int worker) override;
  bool tells_cheaply(TreeId a, TreeId b) override;
  void thin(const std::function<void(const glm::dvec2&)>& visit) const override;

  /// Keeps the sample that the `render` below has taken for a place of its lattice, row by row, so
  /// that it is not traced again. `repeats`: is its tree that of the worker's sample before?
  void keep(std::size_t place, const glm::vec3& colour, const RayTree& tree, bool repeats,
            int worker);

  const RayTree& tree(TreeId id) const { return trees_.tree(id); }

  /// Rays traced so far. Not while others sample.
  RayCounts rays() const;

 private:
  // What is the same for all samples of one tree.
  struct Met {
    TreeId tree{};
    bool textured = false;
    bool background = false;
  };
  struct alignas(64) Worker {
    TraceScratch scratch;
    RepeatRecorder recorder;
    std::optional<Met> met;   // by the recorder's tree
    std::optional<Met> kept;  // by that of the sample kept last
  };

  Met meet(const RayTree& tree);
  ColourSample sample_of(const glm::vec3& colour, const Met& met) const;
  const ColourSample* kept_at(const glm::dvec2& point) const;

  const Accel& accel_;
  Camera camera_;
  int width_;
  int height_;
  ImagePlane plane_;
  int levels_;
  Backdrop backdrop_;
  std::vector<bool> textured_;  // by primitive; empty if none is
  TreeTable trees_;
  std::vector<Worker> workers_;
  std::vector<ColourSample> kept_;  // by place; empty if none are
};

/// Renders as `render` does. `keeper`, which is of the same scene, camera, size and levels, keeps
/// all samples.
Rendering render(const Accel& accel, const Camera& camera, const RenderSettings& settings,
                 SceneSampler& keeper);

}  // namespace raycat
