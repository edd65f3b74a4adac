#pragma once

#include "tracer/scene.hpp"

namespace raycat::reference {

/// A scene of a random number's making in which objects share surfaces: what stands on a floor,
/// side by side or one in another and flush, water in its glass, decals. The world is turned, so
/// that what coincides does so but for rounding.
Scene coincident_scene(unsigned seed);

}  // namespace raycat::reference
