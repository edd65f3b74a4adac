#include "io/openscad/context.hpp"

#include <fmt/format.h>

#include "io/openscad/lexer.hpp"

namespace raycat::openscad {

namespace {

// About 4 GB of meshes.
constexpr std::uint64_t most_triangles = 20'000'000;

}  // namespace

std::string said_of(const Node& node, std::string_view what) {
  return fmt::format("{}: {}: {}", line_place(node.line), node.name, what);
}

void Context::fail(const Node& node, const std::string& what) {
  throw NodeError(said_of(node, what));
}

void Context::warn(const Node& node, std::string_view what) {
  warnings.push_back(said_of(node, what));
}

void Context::warn_of_alpha(const Node& node) {
  if (!warned_of_alpha) {
    warn(node, "solids are opaque; alpha is ignored, here and wherever else it is below 1");
    warned_of_alpha = true;
  }
}

void Context::require_triangles(const Node& node, std::uint64_t more) const {
  if (more > most_triangles - triangles) {
    fail(node, fmt::format(".csg files hold at most {} triangles, but this makes it {}",
                           most_triangles, triangles + more));
  }
}

void Context::count_triangles(const Node& node, std::uint64_t more) {
  require_triangles(node, more);
  triangles += more;
}

std::uint32_t Context::corners(const Node& node, const FacetRule& rule, double radius) const {
  try {
    return facet_count(radius, rule);
  } catch (const std::length_error& error) {
    fail(node, error.what());
  }
}

}  // namespace raycat::openscad
