// The gate that glTF files pass: .gltf and .glb, told by their first bytes.

#include <cstddef>
#include <cstdint>

#include "fuzz/loaded_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  raycat::load_bytes({data, size}, "scene.gltf");
  return 0;
}
