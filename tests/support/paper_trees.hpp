#pragma once

#include "raytree/ray_tree.hpp"

/// The trees that the paper draws, with its letters. C, B and A are surfaces, L a light.
namespace raycat::paper {

inline constexpr SurfaceId A{0}, B{1}, C{2};
inline constexpr LightMask L = 1;

// Fig. 2. Ray a refracts into A and is reflected within it; ray b is reflected to B; ray c misses.
// The paper's strings, ALALA and BLAL, have a root without L in one and with it in the other.
inline const RayTree fig2_a{{.position = 5, .lights = L, .surface = A},
                            {.position = 2, .lights = L, .surface = A},
                            {.surface = A}};
inline const RayTree fig2_b{{.position = 3, .lights = L, .surface = B},
                            {.lights = L, .surface = A}};
inline const RayTree fig2_c{};

// Fig. 3: two mirrors, the first of one ray being the second of the other.
inline const RayTree fig3_a{{.position = 3, .surface = B}, {.surface = A}};
inline const RayTree fig3_b{{.position = 3, .surface = A}, {.surface = B}};

// Fig. 4: C leads to B, and B to A, by refraction in one tree and by reflection in the other.
inline const RayTree fig4_a{
    {.position = 4, .surface = A}, {.position = 2, .lights = L, .surface = B}, {.surface = C}};
inline const RayTree fig4_b{
    {.position = 7, .surface = A}, {.position = 3, .lights = L, .surface = B}, {.surface = C}};

}  // namespace raycat::paper
