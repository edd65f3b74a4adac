// Mesh files: the first letter says which kind, of o(bj), (o)f(f), p(ly) and s(tl).

#include <cstddef>
#include <cstdint>

#include "fuzz/loaded_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return 0;
  }
  const char* name = data[0] == 'o'   ? "mesh.obj"
                     : data[0] == 'f' ? "mesh.off"
                     : data[0] == 'p' ? "mesh.ply"
                                      : "mesh.stl";
  raycat::load_bytes({data + 1, size - 1}, name);
  return 0;
}
