#include "io/gltf/assets.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "io/files/excerpt.hpp"
#include "io/files/input_file.hpp"
#include "io/files/load_error.hpp"
#include "io/gltf/scene.hpp"
#include "io/gltf/uri.hpp"

namespace raycat {
namespace {

// Each file that places another is read while the first is, so this bounds the stack.
constexpr std::size_t max_nesting = 16;

}  // namespace

std::shared_ptr<const SceneFile> GltfAssets::load(const GltfDocument& document, std::size_t node,
                                                  const NodeExtras::Asset& asset) {
  const auto fail = [&](const std::string& what) {
    throw LoadError(document.file, document.node_place(node),
                    fmt::format("extras.asset: '{}' {}", excerpt(asset.uri), what));
  };
  std::filesystem::path file;
  try {
    file = resolve_uri(document.file.parent_path(), asset.uri);
  } catch (const std::runtime_error& error) {
    throw LoadError(document.file, document.node_place(node),
                    fmt::format("extras.asset: {}", error.what()));
  }
  std::error_code error;
  const Key key(std::filesystem::weakly_canonical(file, error), asset.node.value_or(""));
  auto& loaded = loaded_[key];
  if (loaded) {
    return loaded;
  }
  if (std::ranges::find(loading_, key) != loading_.end()) {
    fail("places itself");
  }
  if (loading_.size() == max_nesting) {
    fail(fmt::format("is nested more than {} files deep", max_nesting));
  }
  require_regular_file(file);
  // By content too: a GLB of another name could else place itself unseen.
  const SceneKind kind = scene_kind(file);
  if (asset.node && kind != SceneKind::gltf) {
    fail("has no named nodes; only .gltf and .glb have");
  }
  loading_.push_back(key);
  loaded = std::make_shared<const SceneFile>(kind == SceneKind::gltf
                                                 ? read_gltf_scene(file, asset.node, *this)
                                                 : read_other_(file, kind, options_));
  loading_.pop_back();
  return loaded;
}

}  // namespace raycat
