#pragma once

#include <OpenImageIO/imageio.h>

#include "io/images/image_file.hpp"

namespace raycat {

/// Puts where an image comes from into the header of its file, and that its values are linear, or
/// sRGB.
void describe(const Provenance& provenance, bool linear, OIIO::ImageSpec& spec);

}  // namespace raycat
