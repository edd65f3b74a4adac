#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "io/files/input_file.hpp"
#include "io/files/load_budget.hpp"

namespace raycat {

/// A .gltf or .glb file taken apart, its JSON not yet looked at.
// NOLINTNEXTLINE(bugprone-exception-escape): nlohmann checks what it moves, which never throws.
struct GltfContainer {
  nlohmann::json json;                   ///< nested at most 256 deep
  std::shared_ptr<const Bytes> bytes;    ///< the file, which `binary` is part of
  std::span<const std::uint8_t> binary;  ///< the BIN chunk, or empty
  bool has_binary = false;
  std::vector<std::string> warnings;
};

/// Throws `LoadError`.
GltfContainer open_container(const std::filesystem::path& file, LoadBudget& budget);

}  // namespace raycat
