#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "io/files/scene_kind.hpp"
#include "io/gltf/document.hpp"
#include "io/gltf/extras.hpp"
#include "io/scene/scene_file.hpp"

namespace raycat {

/// Reads a scene file of a kind that is known.
using OtherReader = std::function<SceneFile(const std::filesystem::path& file, SceneKind kind,
                                            const LoadOptions& options)>;

/// The files that nodes place by `asset` extras, each read once however often it is placed.
class GltfAssets {
 public:
  /// `read_other` reads what is not glTF.
  GltfAssets(LoadOptions options, OtherReader read_other)
      : options_(std::move(options)),
        read_other_(std::move(read_other)),
        budget_(options_.limits) {}

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
  OtherReader read_other_;
  LoadBudget budget_;
  std::map<Key, std::shared_ptr<const SceneFile>> loaded_;
  std::vector<Key> loading_;
};

}  // namespace raycat
