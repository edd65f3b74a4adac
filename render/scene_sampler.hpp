#pragma once

#include <vector>

#include "antialias/sampler.hpp"
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
  /// Keeps a reference to the accelerator.
  SceneSampler(const Accel& accel, const Camera& camera, int width, int height, int levels,
               int threads, Backdrop backdrop = Backdrop::shown);

  ColourSample sample(const glm::dvec2& point, int worker) override;
  std::optional<TreeId> side(const glm::dvec2& point, TreeId a, TreeId b, int worker) override;
  bool tells_cheaply(TreeId a, TreeId b) override;
  void thin(const std::function<void(const glm::dvec2&)>& visit) const override;

  const RayTree& tree(TreeId id) const { return trees_.tree(id); }

  /// Rays traced so far. Not while others sample.
  RayCounts rays() const;

 private:
  struct alignas(64) Worker {
    TraceScratch scratch;
    RepeatRecorder recorder;
    bool known = false;  // is there a tree before?
    TreeId tree{};
    bool textured = false;
  };

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
};

}  // namespace raycat
