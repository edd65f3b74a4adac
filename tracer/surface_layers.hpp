#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tracer/scene.hpp"
#include "tracer/surface_layer.hpp"

namespace raycat {

/// In which order rays meet surfaces of different objects, or primitives, that lie in one
/// (docs/design.md, Coincident surfaces). Of surfaces that face the same way, those that let light
/// through are outside of those that do not, and then the first of the file is. Found once for a
/// scene; empty where nothing coincides.
class SurfaceLayers {
 public:
  explicit SurfaceLayers(const Scene& scene);

  bool any() const noexcept { return !layers_.empty(); }

  /// How far apart, in units of the scene, two places on a layer's surface may be found to be.
  double place(const SurfaceLayer& layer) const noexcept { return place_[layer.surface]; }

  SurfaceLayer of_solid(std::size_t solid, const Boundary& boundary) const noexcept {
    return any() ? layer(leaves_[solid] + boundary.leaf, boundary.piece) : SurfaceLayer();
  }

  SurfaceLayer of_mesh(std::size_t instance, std::uint32_t triangle) const noexcept {
    return any() ? layer(meshes_ + instance, triangle) : SurfaceLayer();
  }

  /// Has any of its triangles one?
  bool any_of_mesh(std::size_t instance) const noexcept {
    return any() && first_[meshes_ + instance] != none;
  }

 private:
  static constexpr std::uint32_t none = SurfaceLayer::none;

  SurfaceLayer layer(std::size_t part, std::uint32_t piece) const noexcept {
    return first_[part] == none ? SurfaceLayer() : layers_[first_[part] + piece];
  }

  std::vector<double> place_;         // by surface
  std::vector<std::size_t> leaves_;   // by solid, the part that is its first leaf
  std::size_t meshes_ = 0;            // the part that is the first mesh
  std::vector<std::uint32_t> first_;  // by part, into `layers_`; `none` where nothing is shared
  std::vector<SurfaceLayer> layers_;  // by piece
};

}  // namespace raycat
