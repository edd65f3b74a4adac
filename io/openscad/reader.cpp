#include "io/openscad/reader.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "io/files/input_file.hpp"
#include "io/files/load_error.hpp"
#include "io/openscad/context.hpp"
#include "io/openscad/lexer.hpp"
#include "io/openscad/parser.hpp"
#include "io/openscad/program.hpp"
#include "io/openscad/solids.hpp"
#include "io/openscad/touching_boxes.hpp"
#include "io/openscad/view.hpp"
#include "tracer/srgb.hpp"

namespace raycat {

namespace {

using namespace openscad;

// OpenSCAD's "Cornfield" colours, sRGB.
constexpr glm::vec3 solid_colour = glm::vec3(249.0f, 215.0f, 44.0f) / 255.0f;
constexpr glm::vec3 cut_colour = glm::vec3(157.0f, 203.0f, 81.0f) / 255.0f;
constexpr glm::vec3 background_colour = glm::vec3(255.0f, 255.0f, 229.0f) / 255.0f;

glm::vec3 linear(const glm::vec3& srgb) {
  return {linear_from_srgb(srgb.r), linear_from_srgb(srgb.g), linear_from_srgb(srgb.b)};
}

FacetRule facet_rule(const std::filesystem::path& file, const File& parsed) {
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
      throw LoadError(file, line_place(assignment.line),
                      fmt::format("{} must be a number", assignment.name));
    }
    *to = *assignment.value.number();
  }
  return rule;
}

// Builds the objects of the scene from the usable nodes.
class Builder {
 public:
  Builder(Solids& solids, SceneFile& out)
      : from_(solids.items), root_(solids.root), is_cut_(from_.nodes.size()), out_(out) {}

  // Nodes at the top that touch are one object, so that where solids overlap or meet there is no
  // surface inside; others are objects of their own.
  void build() {
    std::vector<std::uint32_t> tops;
    std::vector<Bounds> boxes;
    Bounds all;
    for (std::uint32_t at = root_; at < from_.nodes[root_].end;) {
      const Item& item = from_.items[at];
      if (!item.usable) {
        at = from_.nodes[at].end;
      } else if (!item.solid && (item.kind == Kind::unite || item.kind == Kind::resize)) {
        ++at;
      } else {
        tops.push_back(at);
        boxes.push_back(item.bounds);
        all.include(item.bounds);
        at = from_.nodes[at].end;
      }
    }
    if (tops.empty()) {
      out_.warnings.emplace_back("the file holds no solid");
      return;
    }
    mark_cut();
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
  // Which nodes are subtracted, an odd number of times.
  void mark_cut() {
    for (std::uint32_t at = root_; at < from_.nodes[root_].end; ++at) {
      const bool subtracts = from_.items[at].kind == Kind::subtract && !from_.items[at].solid;
      bool first = true;
      for (std::uint32_t child = at + 1; child < from_.nodes[at].end;
           child = from_.nodes[child].end) {
        is_cut_[child] = is_cut_[at] != (subtracts && !first);
        first = first && !from_.items[child].usable;
      }
    }
  }

  void add_object(const std::vector<std::uint32_t>& parts) {
    out_.scene.surfaces.add_object(unique_name(parts.front(), object_names_));
    CsgTree tree;
    std::vector<MaterialId> materials;
    std::vector<CsgTree::NodeId> operands;
    for (const std::uint32_t part : parts) {
      operands.push_back(add_tree(from_, part, tree, [&](std::uint32_t at) {
        materials.push_back(material(at));
        return leaf(at);
      }));
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

  CsgLeaf leaf(std::uint32_t at) {
    PlacedShape& shape = from_.shapes[*from_.items[at].solid];
    const SurfaceId first =
        out_.scene.surfaces.add_primitive(unique_name(at, primitive_names_), shape.face_count());
    return {.shape = std::move(shape), .first_face = first};
  }

  MaterialId material(std::uint32_t at) {
    const Item& item = from_.items[at];
    const glm::vec3 colour = item.colour.value_or(is_cut_[at] ? cut_colour : solid_colour);
    std::vector<Material>& materials = out_.scene.materials;
    const auto [found, is_new] =
        material_of_.try_emplace(std::tuple(colour.r, colour.g, colour.b),
                                 MaterialId{static_cast<std::uint32_t>(materials.size())});
    if (is_new) {
      Material added;
      added.name = item.colour ? fmt::format("colour {:g} {:g} {:g}", colour.r, colour.g, colour.b)
                   : is_cut_[at] ? "cut"
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
    std::string name = fmt::format("{} line {}", from_.nodes[at].name, from_.nodes[at].line);
    const int count = ++names[name];
    return count == 1 ? name : fmt::format("{} ({})", name, count);
  }

  Items& from_;
  std::uint32_t root_;
  std::vector<bool> is_cut_;
  SceneFile& out_;
  std::map<std::tuple<float, float, float>, MaterialId> material_of_;
  std::map<std::string, int> object_names_;
  std::map<std::string, int> primitive_names_;
};

}  // namespace

namespace {

SceneFile read(const std::filesystem::path& file, const std::string& text,
               const LoadOptions& options) {
  const File parsed = parse(file, text);
  SceneFile out;
  out.up = {0.0, 0.0, 1.0};
  out.viewed_from = default_direction();
  out.scene.background = linear(background_colour);
  if (std::optional<Camera> camera = view(file, parsed)) {
    out.scene.cameras.push_back(*std::move(camera));
  }
  Context context{.file = file,
                  .options = options,
                  .facets = facet_rule(file, parsed),
                  .warnings = out.warnings};
  Solids solids = evaluate(context, parsed);
  Builder(solids, out).build();
  return out;
}

}  // namespace

SceneFile read_openscad(const std::filesystem::path& file, SceneKind kind,
                        const LoadOptions& options) {
  if (kind != SceneKind::scad) {
    return read(file, read_input_file(file, most_bytes), options);
  }
  // Lines are those of what openscad made of the file, so that is what messages name.
  std::filesystem::path made = file;
  made += " (as .csg)";
  return read(made, csg_of_program(file), options);
}

}  // namespace raycat
