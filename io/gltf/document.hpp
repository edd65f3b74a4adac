#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "io/files/input_file.hpp"
#include "io/files/load_budget.hpp"
#include "io/gltf/json_fields.hpp"
#include "io/gltf/tinygltf.hpp"

namespace raycat {

/// A glTF document that is safe to read: every property has its type, every index is of something
/// that exists, every accessor lies within its buffer and the nodes are a forest.
///
/// `model` is tinygltf's and holds what glTF 2.0 itself defines, apart from the buffers' bytes and
/// the images: those are ours, since tinygltf reads both without checks. Extensions and extras
/// are read from `json`.
struct GltfDocument {
  std::filesystem::path file;
  nlohmann::json json;
  tinygltf::Model model;
  std::vector<std::span<const std::uint8_t>> buffers;  ///< without data where a URI is missing
  std::vector<std::shared_ptr<const Bytes>> storage;   ///< what `buffers` point into
  std::vector<std::optional<std::size_t>> parents;     ///< of each node
  std::vector<std::string> warnings;

  std::string node_place(std::size_t node) const;

  /// The node's own name, or `node N`.
  std::string node_name(std::size_t node) const;

  /// A member of `object` that is itself an object, or nothing.
  std::optional<JsonFields> extension(const nlohmann::json& object, const std::string& name,
                                      const std::string& place) const;

  /// The bytes of an image: embedded, in a buffer or in a file beside this one. Throws
  /// `std::runtime_error` with the reason if there are none.
  Bytes image_bytes(std::size_t image, LoadBudget& budget) const;

  /// The bytes of a buffer view, before `model` is there. Throws `LoadError` if it has none.
  std::span<const std::uint8_t> json_view_bytes(std::size_t view) const;

  /// The bytes of a buffer view; empty if its buffer has no data.
  std::span<const std::uint8_t> view_bytes(std::size_t view) const;

  /// Part of a buffer. Throws `LoadError` naming the place if the buffer is not there, has no data
  /// or ends before.
  std::span<const std::uint8_t> slice(std::size_t buffer, std::size_t offset, std::size_t length,
                                      const std::string& place) const;

  /// Appends a buffer to `json` and `buffers`, and returns its number.
  std::size_t add_buffer(Bytes bytes);
};

/// Throws `LoadError`.
GltfDocument open_gltf(const std::filesystem::path& file, LoadBudget& budget);

}  // namespace raycat
