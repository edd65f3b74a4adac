#include "io/gltf/extras.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "geometry/mesh.hpp"
#include "geometry/mesh_faces.hpp"
#include "io/files/excerpt.hpp"
#include "io/gltf/shapes.hpp"

namespace raycat {
namespace {

Operation operation(const JsonFields& extras, const std::string& name) {
  if (name == "union") {
    return Operation::set_union;
  }
  if (name == "intersection") {
    return Operation::intersection;
  }
  if (name == "difference") {
    return Operation::difference;
  }
  extras.fail(fmt::format("csg: unknown operation '{}'; expected union, intersection or difference",
                          excerpt(name)));
}

CutMaterial cut_material(const JsonFields& extras, const std::string& name) {
  if (name == "operand") {
    return CutMaterial::operand;
  }
  if (name == "base") {
    return CutMaterial::base;
  }
  extras.fail(
      fmt::format("cut_material: unknown value '{}'; expected operand or base", excerpt(name)));
}

Shape polyhedron(JsonFields& fields) {
  auto points = fields.vectors("points");
  const auto faces = fields.index_lists("faces");
  fields.refuse_others();
  if (!points || !faces) {
    fields.fail(fmt::format("{} is missing", points ? "faces" : "points"));
  }
  return std::make_shared<const ClosedMesh>(triangulate(*std::move(points), *faces));
}

Shape shape(JsonFields& fields) {
  const auto type = fields.type();
  std::optional<Shape> shape = implicit_shape(type, fields);
  try {
    if (type == "torus") {
      shape = Torus{.radius = fields.number("radius").value_or(0.5),
                    .tube = fields.number("tube").value_or(0.25)};
      validate(*shape);
    } else if (type == "polyhedron") {
      shape = polyhedron(fields);
    }
  } catch (const std::invalid_argument& error) {
    fields.fail(error.what());
  }
  if (!shape) {
    fields.fail(
        fmt::format("unknown type '{}'; expected sphere, box, cylinder, capsule, plane, "
                    "torus or polyhedron",
                    excerpt(type)));
  }
  fields.refuse_others();
  return *shape;
}

Camera look_at_pose(JsonFields fields) {
  const auto eye = fields.vector("eye");
  const auto target = fields.vector("target");
  const auto up = fields.vector("up").value_or(glm::dvec3(0.0, 1.0, 0.0));
  fields.refuse_others();
  if (!eye || !target) {
    fields.fail(fmt::format("{} is missing", eye ? "target" : "eye"));
  }
  try {
    return raycat::look_at(*eye, *target, up);
  } catch (const std::invalid_argument& error) {
    fields.fail(error.what());
  }
}

}  // namespace

NodeExtras node_extras(const GltfDocument& document, std::size_t node) {
  NodeExtras extras;
  const auto& json = document.json["nodes"][node];
  const auto found = json.find("extras");
  // Extras may be anything; only an object can hold keys of ours.
  if (found == json.end() || !found->is_object()) {
    return extras;
  }
  JsonFields fields(document.file, document.node_place(node), "extras", *found);
  if (const auto name = fields.string("csg")) {
    extras.csg = operation(fields, *name);
  }
  if (const auto name = fields.string("cut_material")) {
    if (!extras.csg) {
      fields.fail("cut_material: the node has no csg");
    }
    extras.cut_material = cut_material(fields, *name);
  }
  if (auto shape_fields = fields.object("shape")) {
    extras.shape = shape(*shape_fields);
  }
  if (auto asset = fields.object("asset")) {
    const auto uri = asset->string("uri");
    extras.asset = {.uri = uri.value_or(""), .node = asset->string("node")};
    asset->refuse_others();
    if (!uri) {
      asset->fail("uri is missing");
    }
  }
  // Others may use so plain a word for their own, where there is no shape for it to colour.
  if (extras.shape) {
    extras.material = fields.index("material", "materials", document.model.materials.size());
  }
  if (auto pose = fields.object("look_at")) {
    if (document.model.nodes[node].camera < 0) {
      pose->fail("the node has no camera");
    }
    extras.look_at = look_at_pose(*pose);
  }
  if (int{extras.csg.has_value()} + int{extras.shape.has_value()} + int{extras.asset.has_value()} >
      1) {
    fields.fail("a node has only one of csg, shape and asset");
  }
  // Extras with a key of ours are ours, and what else is in them is a mistake. The rest belong to
  // other tools.
  if (extras.csg || extras.shape || extras.asset || extras.look_at) {
    fields.refuse_others();
  }
  return extras;
}

}  // namespace raycat
