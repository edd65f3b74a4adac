#include <fstream>  // tinygltf writes files, and leaves this to others

#define TINYGLTF_IMPLEMENTATION
#include "io/gltf/tinygltf.hpp"
