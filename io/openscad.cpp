#include "io/openscad.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "io/input_file.hpp"
#include "io/openscad_parser.hpp"
#include "io/openscad_solids.hpp"
#include "io/openscad_view.hpp"
#include "io/touching_boxes.hpp"
#include "tracer/srgb.hpp"

namespace raycat {

namespace {

using namespace openscad;

constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 28;

// OpenSCAD's "Cornfield" colours, sRGB.
constexpr glm::vec3 solid_colour = glm::vec3(249.0f, 215.0f, 44.0f) / 255.0f;
constexpr glm::vec3 cut_colour = glm::vec3(157.0f, 203.0f, 81.0f) / 255.0f;
constexpr glm::vec3 background_colour = glm::vec3(255.0f, 255.0f, 229.0f) / 255.0f;

glm::vec3 linear(const glm::vec3& srgb) {
  return {linear_from_srgb(srgb.r), linear_from_srgb(srgb.g), linear_from_srgb(srgb.b)};
}

// Builds the objects of the scene from the living nodes.
class Builder {
 public:
  Builder(const File& parsed, Solids& solids, SceneFile& out)
      : nodes_(parsed.nodes), items_(solids.items), shapes_(solids.shapes), out_(out) {}

  // Nodes at the top that touch are one object, so that where solids overlap or meet there is no
  // surface inside; others are objects of their own.
  void build(std::uint32_t root) {
    std::vector<std::uint32_t> tops;
    std::vector<Bounds> boxes;
    Bounds all;
    for (std::uint32_t at = root; at < nodes_[root].end;) {
      const Item& item = items_[at];
      if (item.alive && !item.top) {
        tops.push_back(at);
        boxes.push_back(item.bounds);
        all.include(item.bounds);
      }
      at = item.alive && item.top ? at + 1 : nodes_[at].end;
    }
    if (tops.empty()) {
      out_.warnings.emplace_back("the file holds no solid");
      return;
    }
    // What a CSG tree takes as one point touches.
    const double tolerance = 1e-7 * glm::length(all.half_size());
    for (Bounds& box : boxes) {
      box.min -= 0.5 * tolerance;
      box.max += 0.5 * tolerance;
    }
    const std::vector<std::uint32_t> group_of = group_touching(boxes);
    std::vector<std::vector<std::uint32_t>> groups(1 + *std::ranges::max_element(group_of));
    for (std::size_t i = 0; i < tops.size(); ++i) {
      groups[group_of[i]].push_back(tops[i]);
    }
    for (const std::vector<std::uint32_t>& group : groups) {
      add_object(group);
    }
  }

 private:
  struct Open {
    std::uint32_t end = 0;
    Operation operation = Operation::set_union;
    std::vector<CsgTree::NodeId> operands;
  };

  void add_object(const std::vector<std::uint32_t>& parts) {
    out_.scene.surfaces.add_object(unique_name(parts.front(), object_names_));
    CsgTree tree;
    std::vector<MaterialId> materials;
    std::vector<CsgTree::NodeId> operands;
    for (const std::uint32_t part : parts) {
      operands.push_back(add_part(part, tree, materials));
    }
    if (operands.size() > 1) {
      tree.add(Operation::set_union, operands);
    }
    if (tree.nodes().size() > 1) {
      out_.csg_nodes += tree.nodes().size();
    }
    out_.scene.solids.push_back(
        {.solid = Solid(std::move(tree)), .materials = std::move(materials)});
  }

  CsgTree::NodeId add_part(std::uint32_t part, CsgTree& tree, std::vector<MaterialId>& materials) {
    const std::uint32_t end = nodes_[part].end;
    std::vector<Open> open{{.end = end, .operation = Operation::set_union, .operands = {}}};
    for (std::uint32_t at = part; at < end;) {
      const Item& item = items_[at];
      if (!item.alive) {
        at = nodes_[at].end;
      } else if (item.kind == Kind::solid) {
        open.back().operands.push_back(tree.add(leaf(at)));
        materials.push_back(material(item));
        at = nodes_[at].end;
      } else {
        const Operation operation = item.kind == Kind::subtract    ? Operation::difference
                                    : item.kind == Kind::intersect ? Operation::intersection
                                                                   : Operation::set_union;
        // A union within a union adds its operands to it.
        if (operation != Operation::set_union || open.back().operation != Operation::set_union) {
          open.push_back({.end = nodes_[at].end, .operation = operation, .operands = {}});
        }
        ++at;
      }
      while (open.size() > 1 && open.back().end <= at) {
        const CsgTree::NodeId closed = close(open.back(), tree);
        open.pop_back();
        open.back().operands.push_back(closed);
      }
    }
    return close(open.back(), tree);
  }

  // An operation of one operand is that operand.
  static CsgTree::NodeId close(const Open& open, CsgTree& tree) {
    return open.operands.size() == 1 ? open.operands.front()
                                     : tree.add(open.operation, open.operands);
  }

  CsgLeaf leaf(std::uint32_t at) {
    PlacedShape& shape = shapes_[items_[at].solid];
    const SurfaceId first =
        out_.scene.surfaces.add_primitive(unique_name(at, primitive_names_), shape.face_count());
    return {.shape = std::move(shape), .first_face = first};
  }

  MaterialId material(const Item& item) {
    const glm::vec3 colour = item.colour.value_or(item.subtracted ? cut_colour : solid_colour);
    std::vector<Material>& materials = out_.scene.materials;
    const auto [found, is_new] =
        material_of_.try_emplace(std::tuple(colour.r, colour.g, colour.b),
                                 MaterialId{static_cast<std::uint32_t>(materials.size())});
    if (is_new) {
      Material added;
      added.name = item.colour ? fmt::format("colour {:g} {:g} {:g}", colour.r, colour.g, colour.b)
                   : item.subtracted ? "cut"
                                     : "solid";
      added.ambient = added.diffuse = linear(colour);
      added.specular = glm::vec3(0.1f);
      added.shininess = 20.0f;
      materials.push_back(std::move(added));
    }
    return found->second;
  }

  // `cylinder line 14`; the second of that name is `cylinder line 14 (2)`.
  std::string unique_name(std::uint32_t at, std::map<std::string, int>& names) const {
    std::string name = fmt::format("{} line {}", nodes_[at].name, nodes_[at].line);
    const int count = ++names[name];
    return count == 1 ? name : fmt::format("{} ({})", name, count);
  }

  const std::vector<Node>& nodes_;
  const std::vector<Item>& items_;
  std::vector<PlacedShape>& shapes_;
  SceneFile& out_;
  std::map<std::tuple<float, float, float>, MaterialId> material_of_;
  std::map<std::string, int> object_names_;
  std::map<std::string, int> primitive_names_;
};

}  // namespace

SceneFile read_openscad(const std::filesystem::path& file, const LoadOptions& /*options*/) {
  const std::string text = read_input_file(file, most_bytes);
  const File parsed = parse(file, text);
  SceneFile out;
  out.up = {0.0, 0.0, 1.0};
  out.scene.background = linear(background_colour);
  if (std::optional<Camera> camera = view(file, parsed)) {
    out.scene.cameras.push_back(*std::move(camera));
  }
  Solids solids = evaluate(file, parsed, out.warnings);
  Builder(parsed, solids, out).build(solids.root);
  return out;
}

}  // namespace raycat
