#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

namespace raycat {

/// `node 3 'ball'`: how messages name a node.
std::string node_place(const nlohmann::json& gltf, std::size_t node);

/// Throws `LoadError` unless every property that is read of a glTF document has its type, what is
/// required is there, and every index is of something that exists. Properties that are not read,
/// like animations, may be anything.
void check_schema(const std::filesystem::path& file, const nlohmann::json& gltf);

}  // namespace raycat
