// The reader of OpenSCAD's .csg files.

#include <cstddef>
#include <cstdint>

#include "fuzz/loaded_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  raycat::load_bytes({data, size}, "scene.csg");
  return 0;
}
