#include "tracer/surface_layers.hpp"

namespace raycat {
SurfaceLayers::SurfaceLayers(const Scene&) {}
}  // namespace raycat
