#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "io/images/provenance.hpp"

namespace raycat {

/// A channel of an image by name, of numbers or of whole ones.
struct Layer {
  std::string name;
  std::variant<std::vector<float>, std::vector<std::uint32_t>> values;  ///< rows from the top
};

/// Throws `std::invalid_argument` unless `path` ends in .exr.
void require_layer_path(const std::filesystem::path& path);

/// Writes an OpenEXR file of these channels, without loss, each with as many values as the image
/// has pixels. The file is there whole or not at all. Throws as `require_layer_path` does, and
/// `std::runtime_error` if it cannot be written.
void write_layers(const std::filesystem::path& path, int width, int height,
                  std::span<const Layer> layers, const Provenance& provenance);

}  // namespace raycat
