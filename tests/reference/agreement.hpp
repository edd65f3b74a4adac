#pragma once

#include <string>

#include "reference/tracing.hpp"
#include "render/render.hpp"
#include "tracer/scene.hpp"

namespace raycat::reference {

/// How a picture of the program compares with the reference's.
struct Agreement {
  int samples = 0;
  int excused = 0;    ///< trees that differ where the reference's own do, 1e-9 of the picture away
  int trees = 0;      ///< other samples whose trees differ
  int edges = 0;      ///< pixels without excused samples that are an edge of one of the two alone
  int colours = 0;    ///< samples of equal trees whose colours differ by more than 1e-4
  std::string first;  ///< where the first difference is, and what it is; empty if there is none
};

/// Renders the scene both ways. The settings' levels are the rules'.
Agreement compare_with_reference(const Scene& scene, const Camera& camera,
                                 const RenderSettings& settings, Rules rules = {});

}  // namespace raycat::reference
