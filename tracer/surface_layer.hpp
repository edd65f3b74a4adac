#pragma once

#include <cstdint>
#include <limits>

namespace raycat {

/// A place among surfaces of different objects that lie in one (docs/design.md, Coincident
/// surfaces): rays meet them as if each were moved a little into its own object, the ones with
/// greater `height` farther.
struct SurfaceLayer {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t surface = none;  ///< that they lie in; `none` where a surface has it for itself
  /// Along the surface's normal. Never 0: below it are those whose object is below, above it the
  /// others.
  std::int32_t height = 0;

  bool shared() const noexcept { return surface != none; }

  /// Does a ray that goes into the object here, or out of it, go along the surface's normal?
  bool along(bool entering) const noexcept { return entering == (height > 0); }

  /// Does a ray that passes both, along the normal or against it, come here later?
  bool past(const SurfaceLayer& other, bool along_normal) const noexcept {
    return along_normal ? height > other.height : height < other.height;
  }
};

struct MeshInstance;

/// Where a ray starts: in free space, or at a hit.
struct Departure {
  const MeshInstance* mesh = nullptr;  ///< of the triangle that it leaves, which is not met again
  std::uint32_t triangle = 0;
  SurfaceLayer layer;
  bool along = true;    ///< does it go along the normal of the layer's surface?
  double reach = 0.0;   ///< how far from its origin surfaces of the same place may be found
  double behind = 0.0;  ///< and how far behind it, in t
};

}  // namespace raycat
