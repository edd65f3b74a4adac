#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace raycat {

/// The category of a ray as words: two rays have the same category when the words are equal.
using CategoryWords = std::vector<std::uint32_t>;

/// The most an encoder will meet in one scene, known once the scene and the detail are chosen.
struct Extent {
  std::uint64_t levels = 0;
  std::uint64_t lights = 0;
  std::uint64_t surfaces = 0;
};

/// Is no count of `scene` past that of `limits`?
constexpr bool within(const Extent& scene, const Extent& limits) noexcept {
  return scene.levels <= limits.levels && scene.lights <= limits.lights &&
         scene.surfaces <= limits.surfaces;
}

/// Throws `std::length_error` if `scene` is past `limits`, naming the encoder and the first
/// count that is. Encoders call it when made, once a scene, and then encode without checks.
void require_within(const Extent& scene, const Extent& limits, std::string_view encoder);

}  // namespace raycat
