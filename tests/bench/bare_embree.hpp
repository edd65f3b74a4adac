#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "geometry/mesh.hpp"
#include "tracer/camera.hpp"

namespace raycat::bench {

/// What a pixel's ray meets first.
struct Seen {
  std::uint32_t geometry = ~std::uint32_t{0};  ///< or face, in our own loop
  std::uint32_t triangle = ~std::uint32_t{0};
  double t = 0.0;
};

/// An image of what is seen, row by row, filled in whole tiles of 16 x 16.
struct SeenImage {
  int width = 0;
  int height = 0;
  std::vector<Seen> pixels;

  SeenImage(int columns, int rows)
      : width(columns),
        height(rows),
        pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

  Seen& at(int x, int y) noexcept {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

inline constexpr int tile = 16;

/// The yardstick for visibility (docs/benchmarks.md): a mesh in Embree's ROBUST scene and nothing
/// around it.
class BareEmbree {
 public:
  explicit BareEmbree(const TriangleMesh& mesh);
  ~BareEmbree();
  BareEmbree(const BareEmbree&) = delete;
  BareEmbree& operator=(const BareEmbree&) = delete;

  /// Fills the tile at (left, top): one ray through the centre of each pixel, made in double and
  /// rounded once; t of the triangle found is computed again in double.
  void single_rays(const ImagePlane& plane, int left, int top, SeenImage& out) const;

  /// The same with coherent packets of 4 x 4 pixels, and t in float as Embree finds it.
  void packets(const ImagePlane& plane, int left, int top, SeenImage& out) const;

  /// The most that Embree held at once while it built its index, with its vertices.
  std::size_t peak_bytes() const noexcept;

 private:
  struct Handles;

  const TriangleMesh& mesh_;
  std::unique_ptr<Handles> handles_;
};

}  // namespace raycat::bench
