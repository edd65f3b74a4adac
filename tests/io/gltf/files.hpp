#pragma once

#include <algorithm>
#include <filesystem>
#include <vector>

namespace raycat {

/// All .gltf and .glb files in a folder and below it, in the order of their paths.
inline std::vector<std::filesystem::path> gltf_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const auto extension = entry.path().extension();
    if (extension == ".gltf" || extension == ".glb") {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace raycat
