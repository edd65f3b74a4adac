#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "io/openscad/facets.hpp"
#include "io/openscad/parser.hpp"
#include "io/scene/scene_file.hpp"

namespace raycat::openscad {

/// A node that cannot be made. The reader ends with it as a `LoadError`, or with `keep_going`
/// warns of it and takes the node for an empty one.
struct NodeError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a message says of a node: line, name and `what`.
std::string said_of(const Node& node, std::string_view what);

/// What all that makes geometry of a file's nodes shares.
struct Context {
  const std::filesystem::path& file;
  const LoadOptions& options;
  FacetRule facets;  ///< where a node has none of its own
  std::vector<std::string>& warnings;
  std::uint64_t triangles = 0;  ///< made so far
  bool warned_of_alpha = false;

  /// Throws `NodeError` with the node's line and name.
  [[noreturn]] static void fail(const Node& node, const std::string& what);

  void warn(const Node& node, std::string_view what);

  /// That a colour's alpha is ignored, the first time.
  void warn_of_alpha(const Node& node);

  /// Throws `NodeError` if `more` triangles would make it past 20 million in a file.
  void require_triangles(const Node& node, std::uint64_t more) const;

  /// Counts triangles that a node makes. Throws as `require_triangles` does.
  void count_triangles(const Node& node, std::uint64_t more);

  /// The corners of a circle in `node`, whose $fn, $fa and $fs count before the file's. Throws
  /// `NodeError` past a million.
  std::uint32_t corners(const Node& node, const FacetRule& rule, double radius) const;
};

}  // namespace raycat::openscad
