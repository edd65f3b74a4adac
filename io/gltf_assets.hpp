#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "io/gltf_document.hpp"
#include "io/gltf_extras.hpp"
#include "io/scene_file.hpp"

namespace raycat {

/// The files that nodes place by `asset` extras, each read once however often it is placed.
class GltfAssets {
 public:
  explicit GltfAssets(const LoadOptions& options) : options_(options), budget_(options.limits) {}

  /// What `asset` names, for a node of `document`. Throws `LoadError` if it cannot be read, is
  /// not below the document's folder or places itself.
  std::shared_ptr<const SceneFile> load(const GltfDocument& document, std::size_t node,
                                        const NodeExtras::Asset& asset);

  const LoadOptions& options() const noexcept { return options_; }

  /// Is a file being read that another places?
  bool nested() const noexcept { return !loading_.empty(); }

  /// What is left for all files together.
  LoadBudget& budget() noexcept { return budget_; }

 private:
  using Key = std::pair<std::filesystem::path, std::string>;

  LoadOptions options_;
  LoadBudget budget_;
  std::map<Key, std::shared_ptr<const SceneFile>> loaded_;
  std::vector<Key> loading_;
};

}  // namespace raycat
