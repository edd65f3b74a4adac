#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "io/gltf/document.hpp"

namespace raycat {

/// The polygon of each triangle that a primitive's list of indices makes, where the file tells its
/// polygons: by EXT_mesh_polygon's offsets, or by FB_ngon_encoding, in which triangles that follow
/// each other and begin with the same vertex are one. Nothing where it does not; what cannot be
/// read is left out with a warning.
std::optional<std::vector<std::uint32_t>> authored_polygons(GltfDocument& document,
                                                            std::size_t mesh, std::size_t primitive,
                                                            std::span<const glm::uvec3> triangles);

/// The edges that CESIUM_primitive_outline draws, as pairs of the file's vertices, of which there
/// are `count`. Nothing where there are none; what cannot be read is left out with a warning.
std::optional<std::vector<glm::uvec2>> authored_outline(GltfDocument& document, std::size_t mesh,
                                                        std::size_t primitive, std::size_t count);

}  // namespace raycat
