#include "io/openscad/solids.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/mat3x2.hpp>
#include <glm/mat4x4.hpp>

#include "io/files/load_error.hpp"
#include "io/openscad/file.hpp"
#include "io/openscad/flat.hpp"
#include "io/openscad/frame.hpp"
#include "io/openscad/made.hpp"
#include "io/openscad/operand.hpp"
#include "modelling/convex_hull.hpp"
#include "modelling/mesh_minkowski_sum.hpp"

namespace raycat::openscad {

namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};

// Squares and products of coordinates this large are still finite, and so are volumes.
constexpr double most_coordinate = 1e50;

// Resizes within each other each go through all that is below them.
constexpr std::uint64_t most_resized = 100'000'000;

class Evaluator {
 public:
  Evaluator(Context& context, const File& parsed) : context_(context), nodes_(parsed.nodes) {
    out_.items.nodes = nodes_;
    items_.resize(nodes_.size());
    passing_.resize(nodes_.size());
  }

  Solids evaluate() {
    find_root();
    for (std::uint32_t at = out_.root; at < root_end();) {
      at = enter(at);
    }
    for (std::uint32_t at = root_end(); at-- > out_.root;) {
      if (passing_[at].present && !is_primitive(items_[at].kind)) {
        attempt(at, [&] { leave(at); });
      }
    }
    return std::move(out_);
  }

 private:
  // What only the evaluation needs to know of a node.
  struct Passing {
    bool present = false;
    bool faceted = false;     // is it an operand of what works on triangles?
    bool exists = false;      // is there any of it?
    bool singular = false;    // a multmatrix that flattens space
    std::uint32_t frame = 0;  // index into frames_, or `none` if it is singular
    std::uint32_t map = 0;    // of a multmatrix, its own: index into frames_
    Polygons flat;            // of what is two-dimensional
  };

  std::uint32_t root_end() const { return nodes_[out_.root].end; }

  void find_root();
  std::uint32_t enter(std::uint32_t at);
  void multmatrix(std::uint32_t at);
  void primitive(std::uint32_t at);
  void place(std::uint32_t at, std::optional<Primitive> primitive);

  void leave(std::uint32_t at);
  std::vector<std::uint32_t> operands(std::uint32_t at);
  void combine_flat(std::uint32_t at, const std::vector<std::uint32_t>& operands);
  void combine_solid(std::uint32_t at, const std::vector<std::uint32_t>& operands);
  void hull(std::uint32_t at, const std::vector<std::uint32_t>& operands);
  void minkowski(std::uint32_t at, const std::vector<std::uint32_t>& operands);
  bool unite_solids(std::uint32_t at, const std::vector<std::uint32_t>& operands);
  void project(std::uint32_t at, const std::vector<std::uint32_t>& operands);
  void resize(std::uint32_t at);
  Polygons united(const std::vector<std::uint32_t>& operands);
  void set_flat(std::uint32_t at, Polygons flat);

  // Runs `make`; what it throws of a node ends the reading, or with `keep_going` leaves the node
  // empty.
  template <typename Make>
  void attempt(std::uint32_t at, const Make& make) {
    try {
      make();
    } catch (const NodeError& error) {
      refuse(at, error.what());
    } catch (const LoadError&) {
      throw;
    } catch (const std::runtime_error& error) {
      refuse(at, said_of(nodes_[at], error.what()));
    } catch (const std::logic_error& error) {
      refuse(at, said_of(nodes_[at], error.what()));
    }
  }
  void refuse(std::uint32_t at, const std::string& why);

  Context& context_;
  const std::vector<Node>& nodes_;
  std::vector<Passing> passing_;
  std::vector<glm::dmat4> frames_{glm::dmat4(1.0)};
  std::uint64_t resized_ = 0;
  Solids out_;
  std::vector<Item>& items_ = out_.items.items;
};

void Evaluator::refuse(std::uint32_t at, const std::string& why) {
  if (!context_.options.keep_going) {
    throw LoadError(context_.file, "", why);
  }
  context_.warnings.push_back(why + "; left out");
  passing_[at].exists = false;
  items_[at].usable = false;
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

// On the way down: kinds, frames, colours and primitives. Returns the node to go on with.
std::uint32_t Evaluator::enter(std::uint32_t at) {
  const Node& node = nodes_[at];
  Passing& passing = passing_[at];
  if (at != out_.root) {
    if (node.disabled || node.background) {
      return node.end;
    }
    const Passing& parent = passing_[node.parent];
    const bool apart = !is_set_operation(items_[node.parent].kind);
    const bool own_frame = apart || items_[node.parent].kind == Kind::resize;
    passing.frame = own_frame ? 0 : parent.frame;
    passing.faceted = parent.faceted || apart;
    items_[at].colour = items_[node.parent].colour;
  }
  const std::optional<Kind> kind = kind_of(node.name);
  if (!kind) {
    attempt(at, [&] {
      Context::fail(node, node.name == "roof" ? "is not supported" : "unknown node");
    });
    return node.end;
  }
  passing.present = true;
  items_[at].kind = *kind;
  attempt(at, [&] {
    if (node.name == "multmatrix") {
      multmatrix(at);
    } else if (node.name == "color") {
      const std::optional<glm::vec3> colour = colour_of(context_, node);
      items_[at].colour = items_[at].colour ? items_[at].colour : colour;  // the outermost wins
    }
    if (is_primitive(*kind)) {
      primitive(at);
    }
  });
  if (is_primitive(*kind) && node.end != at + 1) {
    context_.warn(node, "its children are ignored");
  }
  return is_primitive(*kind) ? node.end : at + 1;
}

void Evaluator::multmatrix(std::uint32_t at) {
  const glm::dmat4 matrix = matrix_of(context_, nodes_[at]);
  passing_[at].map = static_cast<std::uint32_t>(frames_.size());
  frames_.push_back(matrix);
  std::uint32_t& frame = passing_[at].frame;
  if (frame == none) {
    return;
  }
  try {
    const Affine invertible(frames_[frame] * matrix);
    frame = static_cast<std::uint32_t>(frames_.size());
    frames_.push_back(invertible.matrix());
  } catch (const std::invalid_argument&) {
    frame = none;
    passing_[at].singular = true;
  }
}

void Evaluator::primitive(std::uint32_t at) {
  const Node& node = nodes_[at];
  const Kind kind = items_[at].kind;
  if (kind == Kind::flat) {
    set_flat(at, flat_primitive(context_, node));
    return;
  }
  items_[at].dimension = 3;
  place(at, kind == Kind::file
                ? file_primitive(context_, node)
                : solid_primitive(context_, node,
                                  passing_[at].faceted ? Roundness::faceted : Roundness::as_asked));
}

// Makes the node a leaf.
void Evaluator::place(std::uint32_t at, std::optional<Primitive> primitive) {
  const std::uint32_t frame = passing_[at].frame;
  if (!primitive || frame == none) {
    return;
  }
  Item& item = items_[at];
  try {
    PlacedShape placed(std::move(primitive->shape), Affine(frames_[frame] * primitive->frame));
    const Bounds& box = placed.bounds();
    for (int axis = 0; axis < 3; ++axis) {
      const double most = std::max(std::abs(box.min[axis]), std::abs(box.max[axis]));
      if (!(most <= most_coordinate)) {
        Context::fail(nodes_[at], fmt::format("coordinates are at most {:g}, but this reaches {:g}",
                                              most_coordinate, most));
      }
    }
    item.bounds = box;
    item.solid = static_cast<std::uint32_t>(out_.items.shapes.size());
    out_.items.shapes.push_back(std::move(placed));
    item.usable = true;
    passing_[at].exists = true;
  } catch (const std::invalid_argument& error) {
    Context::fail(nodes_[at], error.what());
  }
}

void Evaluator::set_flat(std::uint32_t at, Polygons flat) {
  items_[at].dimension = 2;
  passing_[at].exists = !flat.contours.empty();
  passing_[at].flat = std::move(flat);
}

// The children that count, in order: all of the dimension that the node works in, which is set,
// and those that are nothing at all.
std::vector<std::uint32_t> Evaluator::operands(std::uint32_t at) {
  const Kind kind = items_[at].kind;
  std::vector<std::uint32_t> children;
  std::uint8_t dimension = kind == Kind::project                            ? 3
                           : kind == Kind::extrude || kind == Kind::flatten ? 2
                                                                            : 0;
  for (std::uint32_t child = at + 1; child < nodes_[at].end; child = nodes_[child].end) {
    if (passing_[child].present) {
      children.push_back(child);
      dimension = dimension == 0 ? items_[child].dimension : dimension;
    }
  }
  std::erase_if(children, [&](std::uint32_t child) {
    const std::uint8_t its = items_[child].dimension;
    if (its == 0 || its == dimension) {
      return false;
    }
    context_.warn(nodes_[child], dimension == 3
                                     ? "is two-dimensional and ignored in three dimensions"
                                     : "is three-dimensional and ignored in two dimensions");
    return true;
  });
  items_[at].dimension = dimension;
  return children;
}

// On the way up: what a node makes of its children.
void Evaluator::leave(std::uint32_t at) {
  const std::vector<std::uint32_t> children = operands(at);
  const Node& node = nodes_[at];
  switch (items_[at].kind) {
    case Kind::extrude:
      items_[at].dimension = 3;
      place(at, extruded(context_, node, united(children)));
      break;
    case Kind::flatten:
      set_flat(at, flattened(context_, node, united(children)));
      break;
    case Kind::project:
      project(at, children);
      break;
    case Kind::hull:
      hull(at, children);
      break;
    case Kind::minkowski:
      minkowski(at, children);
      break;
    default:
      items_[at].dimension == 2 ? combine_flat(at, children) : combine_solid(at, children);
      break;
  }
  if (passing_[at].singular && items_[at].dimension == 3) {
    context_.warn(node, "is singular, so its children have no volume");
  }
}

Polygons Evaluator::united(const std::vector<std::uint32_t>& operands) {
  std::vector<Polygons> flats;
  for (const std::uint32_t operand : operands) {
    if (passing_[operand].exists) {
      flats.push_back(std::exchange(passing_[operand].flat, {}));
    }
  }
  return flats.size() == 1 ? std::move(flats.front()) : combined(Operation::set_union, flats);
}

void Evaluator::combine_flat(std::uint32_t at, const std::vector<std::uint32_t>& operands) {
  const Kind kind = items_[at].kind;
  std::vector<Polygons> flats;
  bool whole = true;
  for (const std::uint32_t operand : operands) {
    const bool exists = passing_[operand].exists;
    if (exists || kind == Kind::subtract) {
      flats.push_back(std::exchange(passing_[operand].flat, {}));
    }
    whole = whole && exists;
  }
  Polygons flat = kind == Kind::intersect && !whole ? Polygons{}
                  : flats.size() == 1               ? std::move(flats.front())
                                      : combined(kind == Kind::subtract    ? Operation::difference
                                                 : kind == Kind::intersect ? Operation::intersection
                                                                           : Operation::set_union,
                                                 flats);
  if (kind == Kind::resize) {
    Bounds box;
    for (const Contour& contour : flat.contours) {
      for (const glm::dvec2& corner : contour) {
        box.include(glm::dvec3(corner, 0.0));
      }
    }
    const glm::dvec3 by = stretch(context_, nodes_[at], box);
    flat = transformed(flat, glm::dmat3x2(by.x, 0.0, 0.0, by.y, 0.0, 0.0));
  } else if (nodes_[at].name == "multmatrix") {
    const glm::dmat4& map = frames_[passing_[at].map];
    const bool existed = !flat.contours.empty();
    flat =
        transformed(flat, glm::dmat3x2(map[0].x, map[0].y, map[1].x, map[1].y, map[3].x, map[3].y));
    if (existed && flat.contours.empty()) {
      context_.warn(nodes_[at], "is singular, so its children have no area");
    }
  }
  set_flat(at, std::move(flat));
}

void Evaluator::combine_solid(std::uint32_t at, const std::vector<std::uint32_t>& operands) {
  Item& item = items_[at];
  bool any = false;
  bool whole = true;
  for (const std::uint32_t operand : operands) {
    any = any || passing_[operand].exists;
    whole = whole && passing_[operand].exists;
    const Bounds& box = items_[operand].bounds;
    if (item.kind == Kind::intersect || item.kind == Kind::subtract) {
      item.bounds = operand == operands.front()    ? box
                    : item.kind == Kind::intersect ? intersection(item.bounds, box)
                                                   : item.bounds;
    } else if (items_[operand].usable) {
      item.bounds.include(box);
    }
  }
  passing_[at].exists =
      !operands.empty() && (item.kind == Kind::intersect  ? whole
                            : item.kind == Kind::subtract ? passing_[operands.front()].exists
                                                          : any);
  item.usable = passing_[at].exists && item.dimension == 3 && !item.bounds.empty();
  if (item.kind == Kind::resize && item.usable) {
    resize(at);
  }
}

// Stretches what is below in its own frame, and takes it to that of the node.
void Evaluator::resize(std::uint32_t at) {
  resized_ += nodes_[at].end - at;
  if (resized_ > most_resized) {
    Context::fail(nodes_[at], "there are too many resizes within each other");
  }
  Bounds box;
  for (const glm::dvec3& point : operand_points(out_.items, at)) {
    box.include(point);
  }
  const std::uint32_t frame = passing_[at].frame;
  Item& item = items_[at];
  item.usable = frame != none && !box.empty();
  if (!item.usable) {
    return;
  }
  const glm::dvec3 by = stretch(context_, nodes_[at], box);
  const glm::dmat4 map =
      frames_[frame] * glm::dmat4(glm::dvec4(by.x, 0.0, 0.0, 0.0), glm::dvec4(0.0, by.y, 0.0, 0.0),
                                  glm::dvec4(0.0, 0.0, by.z, 0.0), glm::dvec4(0.0, 0.0, 0.0, 1.0));
  const Affine affine(map);
  for (std::uint32_t below = at + 1; below < nodes_[at].end; ++below) {
    Item& its = items_[below];
    its.bounds = affine.bounds(its.bounds);
    if (its.solid) {
      PlacedShape& shape = out_.items.shapes[*its.solid];
      shape = PlacedShape(shape.shape(), Affine(map * shape.transform().matrix()));
    }
  }
  item.bounds = affine.bounds(item.bounds);
}

void Evaluator::hull(std::uint32_t at, const std::vector<std::uint32_t>& operands) {
  if (items_[at].dimension == 2) {
    std::vector<Polygons> flats;
    for (const std::uint32_t operand : operands) {
      flats.push_back(std::exchange(passing_[operand].flat, {}));
    }
    set_flat(at, raycat::hull(flats));
    return;
  }
  if (unite_solids(at, operands)) {
    const std::vector<glm::dvec3> points = operand_points(out_.items, at);
    items_[at].usable = false;
    place(at, solid_with_faces(context_, nodes_[at], convex_hull(points)));
  }
}

// Makes the node usable as the union of its operands, if it has any.
bool Evaluator::unite_solids(std::uint32_t at, const std::vector<std::uint32_t>& operands) {
  items_[at].usable =
      std::ranges::any_of(operands, [&](std::uint32_t operand) { return items_[operand].usable; });
  return items_[at].usable;
}

void Evaluator::minkowski(std::uint32_t at, const std::vector<std::uint32_t>& operands) {
  if (items_[at].dimension == 2) {
    Polygons sum;
    for (const std::uint32_t operand : operands) {
      const Polygons flat = std::exchange(passing_[operand].flat, {});
      if (!flat.contours.empty()) {
        sum = sum.contours.empty() ? flat : minkowski_sum(sum, flat);
      }
    }
    set_flat(at, std::move(sum));
    return;
  }
  TriangleMesh sum;
  for (const std::uint32_t operand : operands) {
    if (items_[operand].usable) {
      TriangleMesh mesh = operand_mesh(out_.items, operand);
      sum = sum.triangles.empty() ? std::move(mesh) : minkowski_sum(sum, mesh);
    }
  }
  place(at, solid_with_faces(context_, nodes_[at], std::move(sum)));
}

void Evaluator::project(std::uint32_t at, const std::vector<std::uint32_t>& operands) {
  Polygons flat;
  if (unite_solids(at, operands)) {
    flat = projected(context_, nodes_[at], operand_mesh(out_.items, at));
    items_[at].usable = false;
  }
  set_flat(at, std::move(flat));
}

}  // namespace

Solids evaluate(Context& context, const File& parsed) {
  return Evaluator(context, parsed).evaluate();
}

}  // namespace raycat::openscad
