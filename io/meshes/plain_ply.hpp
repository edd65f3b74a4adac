#pragma once

#include <string>
#include <string_view>

namespace raycat {

struct PlainPly {
  bool binary = false;
  std::string bytes;
};

/// A PLY file with a header of nothing but the elements `vertex` and `face` and their properties,
/// for OpenMesh's reader (see `mesh_text.hpp`). Throws `std::invalid_argument`.
PlainPly plain_ply(std::string_view bytes);

}  // namespace raycat
