#include "io/openscad_solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/mat4x4.hpp>

#include "io/openscad_lexer.hpp"
#include "io/openscad_parameters.hpp"
#include "io/openscad_primitive.hpp"
#include "io/scene_file.hpp"

namespace raycat::openscad {

namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};

// Squares and products of coordinates this large are still finite, and so are volumes.
constexpr double most_coordinate = 1e50;

std::optional<Kind> kind_of(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Kind>, 14> kinds = {{
      {"group", Kind::unite},
      {"union", Kind::unite},
      {"multmatrix", Kind::unite},
      {"color", Kind::unite},
      {"render", Kind::unite},
      {"intersection", Kind::intersect},
      {"difference", Kind::subtract},
      {"cube", Kind::solid},
      {"sphere", Kind::solid},
      {"cylinder", Kind::solid},
      {"polyhedron", Kind::solid},
      {"square", Kind::flat},
      {"circle", Kind::flat},
      {"polygon", Kind::flat},
  }};
  const auto* const found =
      std::ranges::find(kinds, name, &std::pair<std::string_view, Kind>::first);
  return found == kinds.end() ? std::nullopt : std::optional(found->second);
}

bool known_elsewhere(std::string_view name) {
  constexpr std::array<std::string_view, 12> names = {
      "linear_extrude", "rotate_extrude", "hull", "minkowski", "offset", "projection",
      "resize",         "roof",           "fill", "text",      "import", "surface"};
  return std::ranges::find(names, name) != names.end();
}

class Evaluator {
 public:
  Evaluator(const std::filesystem::path& file, const File& parsed,
            std::vector<std::string>& warnings)
      : file_(file),
        nodes_(parsed.nodes),
        warnings_(warnings),
        maker_(file, facet_rule(parsed), warnings) {
    out_.items.resize(nodes_.size());
    passing_.resize(nodes_.size());
  }

  Solids evaluate() {
    find_root();
    descend();
    find_dimensions();
    find_empty();
    mark_alive();
    return std::move(out_);
  }

 private:
  // What only the evaluation needs to know of a node.
  struct Passing {
    bool present = false;
    bool whole = true;           // no operand is empty
    std::uint8_t dimension = 0;  // 2 or 3; 0 for nothing at all
    bool exists = false;
    std::uint32_t frame = 0;     // index into frames_, or `none` if it is singular
    std::uint32_t first = none;  // the first operand
  };

  FacetRule facet_rule(const File& parsed) const;
  void find_root();
  void descend();
  void find_dimensions();
  void find_empty();
  void mark_alive();

  void multmatrix(std::uint32_t at);
  void color(std::uint32_t at);
  void solid(std::uint32_t at);
  [[noreturn]] void fail(const Node& node, const std::string& what) const {
    throw LoadError(file_, line_place(node.line), fmt::format("{}: {}", node.name, what));
  }
  void warn(const Node& node, std::string_view what) {
    warnings_.push_back(fmt::format("line {}: {}: {}", node.line, node.name, what));
  }
  std::uint32_t root_end() const { return nodes_[out_.root].end; }

  const std::filesystem::path& file_;
  const std::vector<Node>& nodes_;
  std::vector<std::string>& warnings_;
  PrimitiveMaker maker_;
  std::vector<Passing> passing_;
  std::vector<glm::dmat4> frames_{glm::dmat4(1.0)};
  bool warned_of_alpha_ = false;
  Solids out_;
};

FacetRule Evaluator::facet_rule(const File& parsed) const {
  FacetRule rule;
  for (const Assignment& assignment : parsed.assignments) {
    double* const to = assignment.name == "$fn"   ? &rule.number
                       : assignment.name == "$fa" ? &rule.angle
                       : assignment.name == "$fs" ? &rule.size
                                                  : nullptr;
    if (to == nullptr) {
      continue;
    }
    if (assignment.value.number() == nullptr) {
      throw LoadError(file_, line_place(assignment.line),
                      fmt::format("{} must be a number", assignment.name));
    }
    *to = *assignment.value.number();
  }
  return rule;
}

void Evaluator::find_root() {
  for (std::uint32_t at = 0; at < nodes_.size();) {
    if (nodes_[at].root && !nodes_[at].disabled) {
      out_.root = at;
      return;
    }
    at = nodes_[at].disabled ? nodes_[at].end : at + 1;
  }
}

// From the root down: frames and colours, and the solids in them.
void Evaluator::descend() {
  for (std::uint32_t at = out_.root; at < root_end();) {
    const Node& node = nodes_[at];
    if (at != out_.root) {
      if (node.disabled || node.background) {
        at = node.end;
        continue;
      }
      passing_[at].frame = passing_[node.parent].frame;
      out_.items[at].colour = out_.items[node.parent].colour;
    }
    const std::optional<Kind> kind = kind_of(node.name);
    if (!kind) {
      fail(node, known_elsewhere(node.name) ? "not supported yet in .csg files" : "unknown node");
    }
    passing_[at].present = true;
    out_.items[at].kind = *kind;
    if (node.name == "multmatrix") {
      multmatrix(at);
    } else if (node.name == "color") {
      color(at);
    }
    if (*kind == Kind::solid) {
      solid(at);
    }
    passing_[at].dimension = *kind == Kind::solid ? 3 : *kind == Kind::flat ? 2 : 0;
    const bool inner = *kind != Kind::solid && *kind != Kind::flat;
    if (!inner && node.end != at + 1) {
      warn(node, "its children are ignored");
    }
    at = inner ? at + 1 : node.end;
  }
}

void Evaluator::multmatrix(std::uint32_t at) {
  const Node& node = nodes_[at];
  const Parameters parameters(file_, node, {"m"}, {}, warnings_);
  const Vector& rows = parameters.vector("m");
  const char* const shape = "m must be 4 rows of 4 numbers";
  if (rows.size() != 4) {
    parameters.fail(shape);
  }
  glm::dmat4 matrix(1.0);
  for (int row = 0; row < 4; ++row) {
    const Vector* const numbers = rows[static_cast<std::size_t>(row)].vector();
    if (numbers == nullptr || numbers->size() != 4) {
      parameters.fail(shape);
    }
    for (int column = 0; column < 4; ++column) {
      const Value& value = (*numbers)[static_cast<std::size_t>(column)];
      if (std::holds_alternative<Unknown>(value.is)) {
        continue;  // keeps the identity's
      }
      if (value.number() == nullptr) {
        parameters.fail(shape);
      }
      matrix[column][row] = *value.number();
    }
  }
  if (matrix[0][3] != 0.0 || matrix[1][3] != 0.0 || matrix[2][3] != 0.0) {
    warn(node, "the fourth row counts only by its last number");
  }
  matrix = matrix / matrix[3][3];
  matrix[0][3] = matrix[1][3] = matrix[2][3] = 0.0;
  matrix[3][3] = 1.0;
  std::uint32_t& frame = passing_[at].frame;
  if (frame == none) {
    return;
  }
  matrix = frames_[frame] * matrix;
  try {
    const Affine invertible(matrix);
    frame = static_cast<std::uint32_t>(frames_.size());
    frames_.push_back(invertible.matrix());
  } catch (const std::invalid_argument&) {
    warn(node, "is singular, so its children have no volume");
    frame = none;
  }
}

void Evaluator::color(std::uint32_t at) {
  const Node& node = nodes_[at];
  const Parameters parameters(file_, node, {"c", "alpha"}, {}, warnings_);
  const Vector& numbers = parameters.vector("c");
  if (numbers.size() != 3 && numbers.size() != 4) {
    parameters.fail("the colour must be [r, g, b, a]");
  }
  std::array<double, 4> colour = {-1.0, -1.0, -1.0, 1.0};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i].number() == nullptr && !std::holds_alternative<Unknown>(numbers[i].is)) {
      parameters.fail("the colour must be [r, g, b, a]");
    }
    colour[i] = numbers[i].number() == nullptr ? -1.0 : *numbers[i].number();
  }
  if (std::ranges::any_of(colour, [](double c) { return c < 0.0; }) || out_.items[at].colour) {
    return;  // unset, or a colour further out wins
  }
  if (std::ranges::any_of(colour, [](double c) { return c > 1.0; })) {
    warn(node, "components above 1 count as 1");
  }
  if (colour[3] < 1.0 && !warned_of_alpha_) {
    warn(node, "solids are opaque; alpha is ignored, here and wherever else it is below 1");
    warned_of_alpha_ = true;
  }
  out_.items[at].colour =
      glm::min(glm::vec3(glm::dvec3(colour[0], colour[1], colour[2])), glm::vec3(1.0f));
}

void Evaluator::solid(std::uint32_t at) {
  const Node& node = nodes_[at];
  const std::uint32_t frame = passing_[at].frame;
  std::optional<Primitive> primitive = maker_.make(node);
  if (!primitive || frame == none) {
    return;
  }
  try {
    const Affine transform(glm::translate(frames_[frame], primitive->offset));
    PlacedShape placed(std::move(primitive->shape), transform);
    const Bounds& box = placed.bounds();
    for (int axis = 0; axis < 3; ++axis) {
      const double most = std::max(std::abs(box.min[axis]), std::abs(box.max[axis]));
      if (!(most <= most_coordinate)) {
        fail(node, fmt::format("coordinates are at most {:g}, but this reaches {:g}",
                               most_coordinate, most));
      }
    }
    out_.items[at].bounds = box;
    out_.items[at].solid = static_cast<std::uint32_t>(out_.shapes.size());
    out_.shapes.push_back(std::move(placed));
    passing_[at].exists = true;
  } catch (const std::invalid_argument& error) {
    fail(node, error.what());
  }
}

// From the last node up, so that of all operands the first has the last word.
void Evaluator::find_dimensions() {
  for (std::uint32_t at = root_end() - 1; at > out_.root; --at) {
    if (passing_[at].present && passing_[at].dimension != 0) {
      passing_[nodes_[at].parent].dimension = passing_[at].dimension;
    }
  }
}

void Evaluator::find_empty() {
  for (std::uint32_t at = root_end() - 1;; --at) {
    Passing& passing = passing_[at];
    Item& item = out_.items[at];
    if (passing.present && passing.first != none) {
      const bool first_exists = passing_[passing.first].exists;
      passing.exists = item.kind == Kind::subtract    ? first_exists
                       : item.kind == Kind::intersect ? passing.whole
                                                      : passing.exists;
    }
    if (at == out_.root) {
      return;
    }
    Passing& parent = passing_[nodes_[at].parent];
    Bounds& around = out_.items[nodes_[at].parent].bounds;
    if (!passing.present || passing.dimension == 2) {
      continue;
    }
    switch (out_.items[nodes_[at].parent].kind) {
      case Kind::subtract:
        around = item.bounds;
        break;
      case Kind::intersect:
        around = parent.first == none ? item.bounds : intersection(around, item.bounds);
        break;
      default:
        if (passing.exists) {
          around.include(item.bounds);
        }
        break;
    }
    parent.first = at;
    parent.whole = parent.whole && passing.exists;
    parent.exists = parent.exists || passing.exists;
  }
}

void Evaluator::mark_alive() {
  for (std::uint32_t at = out_.root; at < root_end(); ++at) {
    const Passing& passing = passing_[at];
    if (!passing.present) {
      continue;
    }
    Item& item = out_.items[at];
    const bool is_root = at == out_.root;
    const Item& parent = out_.items[nodes_[at].parent];
    const std::uint8_t around = is_root ? 3 : passing_[nodes_[at].parent].dimension;
    if (passing.dimension != 0 && around != 0 && passing.dimension != around) {
      warn(nodes_[at], around == 3 ? "is two-dimensional and ignored in three dimensions"
                                   : "is three-dimensional and ignored in two dimensions");
    }
    item.alive = passing.exists && passing.dimension == 3 && around == 3 &&
                 (is_root || parent.alive) && !item.bounds.empty();
    item.top = item.kind == Kind::unite && (is_root || parent.top);
    item.subtracted = !is_root && (parent.subtracted != (parent.kind == Kind::subtract &&
                                                         passing_[nodes_[at].parent].first != at));
  }
}

}  // namespace

Solids evaluate(const std::filesystem::path& file, const File& parsed,
                std::vector<std::string>& warnings) {
  return Evaluator(file, parsed, warnings).evaluate();
}

}  // namespace raycat::openscad
