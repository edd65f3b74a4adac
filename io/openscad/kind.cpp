#include "io/openscad/kind.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace raycat::openscad {

std::optional<Kind> kind_of(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Kind>, 25> kinds = {{
      {"group", Kind::unite},
      {"union", Kind::unite},
      {"multmatrix", Kind::unite},
      {"color", Kind::unite},
      {"render", Kind::unite},
      {"intersection", Kind::intersect},
      {"difference", Kind::subtract},
      {"resize", Kind::resize},
      {"hull", Kind::hull},
      {"minkowski", Kind::minkowski},
      {"linear_extrude", Kind::extrude},
      {"rotate_extrude", Kind::extrude},
      {"projection", Kind::project},
      {"offset", Kind::flatten},
      {"fill", Kind::flatten},
      {"cube", Kind::solid},
      {"sphere", Kind::solid},
      {"cylinder", Kind::solid},
      {"polyhedron", Kind::solid},
      {"square", Kind::flat},
      {"circle", Kind::flat},
      {"polygon", Kind::flat},
      {"text", Kind::flat},
      {"import", Kind::file},
      {"surface", Kind::file},
  }};
  const auto* const found =
      std::ranges::find(kinds, name, &std::pair<std::string_view, Kind>::first);
  return found == kinds.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace raycat::openscad
