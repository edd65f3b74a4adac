#include "io/export/surface_label.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace raycat {

std::string one_word(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return c <= 0x20 || c == 0x7f; }, '_');
  return name.empty() ? "_" : name;
}

std::string surface_label(const SurfaceTable& surfaces, SurfaceId face) {
  return fmt::format("{}/{}/{}", one_word(surfaces.name(surfaces.object(face))),
                     one_word(surfaces.name(surfaces.primitive(face))),
                     surfaces.face_in_primitive(face));
}

}  // namespace raycat
