#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "edges/edge_classes.hpp"

namespace raycat {

/// The sRGB colours of all masks of `EdgeClass` bits, no two alike, so that a picture in these
/// colours holds the masks. No class is white, and a single class has a colour that people of
/// every colour vision tell from the others:
///
///     object      30  30  30  near black        shadow     230 159   0  orange
///     primitive    0 114 178  blue              reflection 204 121 167  magenta
///     face        86 180 233  sky blue          refraction   0 158 115  green
///
/// Several classes have the mean of theirs, channel by channel of sRGB, halves rounded up. So a
/// shadow's edge seen in a mirror is between orange and magenta.
std::array<std::array<std::uint8_t, 3>, 64> edge_class_palette();

/// Which bit is which class: `1 object, 2 primitive, 4 face, ...`.
std::string edge_class_legend();

}  // namespace raycat
