#pragma once

// tinygltf, in a namespace of raycat's: Draco's library has another version of it inside, whose
// symbols would take the place of ours. It is given JSON alone, neither files nor images.
#define tinygltf raycat_tinygltf
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_INCLUDE_JSON

#include <nlohmann/json.hpp>
#include <tiny_gltf.h>
