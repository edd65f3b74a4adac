#include "reference/random_scenes.hpp"

#include <array>
#include <cmath>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "geometry/mesh.hpp"
#include "geometry/mesh_faces.hpp"
#include "geometry/tessellate.hpp"
#include "reference/scene_maker.hpp"
#include "tracer/pbr.hpp"

namespace raycat::reference {
namespace {

class Maker : SceneMaker {
 public:
  using SceneMaker::SceneMaker;

  Scene operator()() {
    if (below(3) == 0) {
      scale_ = std::pow(10.0, between(-3, 4));
      world_ =
          glm::scale(glm::translate(glm::dmat4(1.0), scale_ * vec(-20, 20)), glm::dvec3(scale_));
    }
    add_materials();
    scene_.background = colour(0.0, 1.0);
    scene_.ambient_light = colour(0.0, 0.4);
    const unsigned objects = 1 + below(4);
    for (unsigned i = 0; i < objects; ++i) {
      const glm::dvec3 at{between(-2.2, 2.2), between(0.2, 2.2), between(-2.2, 2.2)};
      switch (below(6)) {
        case 0:
        case 1:
          add_tree(0, glm::translate(glm::dmat4(1.0), at) * bent());
          break;
        case 2:
          add_tree(3, glm::translate(glm::dmat4(1.0), at) * bent());
          break;
        case 3:
          add_lattice(glm::translate(glm::dmat4(1.0), at) * bent());
          break;
        case 4:
          add_triangles(glm::translate(glm::dmat4(1.0), at) * bent());
          break;
        default:
          add_nest(at);
      }
    }
    if (below(3) != 0) {
      const double height = between(-1.5, -0.5);
      add_solid(HalfSpace{}, glm::translate(glm::dmat4(1.0), {0, height, 0}),
                clear_material(any_material()));
    }
    const unsigned lights = below(5);
    for (unsigned i = 0; i < lights; ++i) {
      add_light();
    }
    const glm::dvec3 eye = below(6) == 0 ? glm::dvec3{between(-1, 1), between(0, 2), between(-1, 1)}
                                         : glm::dvec3{between(-4, 4), between(-0.4, 4), 7};
    Camera camera =
        look_at(in_world(eye), in_world({between(-0.5, 0.5), 0.7, between(-3, -2)}), {0, 1, 0.1});
    camera.half_height = 0.4;
    scene_.cameras.push_back(below(5) == 0 ? orthographic(camera, 7.0 * scale_) : camera);
    return std::move(scene_);
  }

 private:
  void add_materials() {
    const auto add = [&](const Material& material) { add_material(material); };
    add({.ambient = colour(0, 0.5), .diffuse = colour(0, 1)});
    add({.emission = colour(0, 0.2),
         .ambient = colour(0, 0.5),
         .diffuse = colour(0, 1),
         .specular = colour(0, 0.6),
         .shininess = static_cast<float>(between(1, 60))});
    add({.diffuse = colour(0, 0.3), .reflection = colour(0.2, 0.9)});
    add(whitted({.base = colour(0, 1), .metallic = 1.0, .roughness = between(0.0, 0.4)}));
    add({.reflection = colour(0, 0.2), .transmission = colour(0.4, 1), .ior = 1.5f});
    add({.diffuse = colour(0, 0.3),
         .specular = colour(0, 0.5),
         .shininess = 20.0f,
         .transmission = colour(0.3, 1),
         .ior = static_cast<float>(between(0.6, 2.4))});
    add({.diffuse = colour(0, 0.3), .transmission = {0.6f, 0.0f, 0.0f}, .thin = true});
    add({.diffuse = colour(0, 0.6), .transmission = {0.0f, 0.4f, 0.9f}, .thin = true});
    add(whitted({.base = colour(0.5, 1),
                 .metallic = 0.0,
                 .roughness = between(0.0, 0.6),
                 .ior = between(1.2, 2.0),
                 .transmission = 1.0,
                 .attenuation_colour = colour(0.2, 0.9),
                 .attenuation_distance = scale_ * between(0.5, 2.0),
                 .thin = false}));
    add(whitted({.base = colour(0, 1),
                 .metallic = 0.0,
                 .roughness = between(0.0, 1.0),
                 .transmission = between(0.1, 0.9)}));
    const auto covered = static_cast<float>(between(0.1, 0.9));
    add({.ambient = colour(0, 0.5),
         .diffuse = colour(0, 1),
         .transmission = glm::vec3(1.0f - covered),
         .thin = true,
         .blend = true,
         .alpha = covered});
  }

  MaterialId any_material() {
    return MaterialId{below(static_cast<unsigned>(scene_.materials.size()))};
  }

  // For what may be without end, or open: light that is absorbed on the way through it is less than
  // any number, or depends on where the hole is.
  MaterialId clear_material(MaterialId wanted) const {
    return material_of(wanted).absorption == glm::vec3(0.0f) ? wanted : MaterialId{4};
  }

  Shape any_shape() {
    switch (below(7)) {
      case 0:
        return Sphere{.radius = between(0.4, 1.1)};
      case 1:
        return Box{.size = {between(0.4, 2), between(0.4, 2), between(0.4, 2)}};
      case 2: {
        const unsigned kind = below(4);  // two cones and two frustums
        return Cylinder{.height = between(0.4, 2),
                        .radius_top = kind == 0 ? 0.0 : between(0.2, 0.9),
                        .radius_bottom = kind == 1 ? 0.0 : between(0.2, 0.9)};
      }
      case 3:
        return Capsule{.height = between(0, 1.5),
                       .radius_top = between(0.2, 0.8),
                       .radius_bottom = between(0.2, 0.8)};
      case 4:  // now and then a spindle
        return Torus{.radius = between(0.3, 1.0), .tube = between(0.1, 0.5)};
      case 5:
        return closed_mesh();
      default:
        return Box{.size = {between(0.4, 2), between(0.1, 0.4), between(0.4, 2)}};
    }
  }

  TriangleMesh any_triangles() {
    return below(2) == 0
               ? tessellate(Box{.size = {between(0.4, 2), between(0.4, 2), between(0.4, 2)}}, 0.1)
               : tessellate(Sphere{.radius = between(0.5, 1.0)}, 0.15);
  }

  Shape closed_mesh() { return std::make_shared<const ClosedMesh>(any_triangles()); }

  // Leaves of one object are of one index and absorption, since a tree is one medium.
  template <typename MakeLeaf>
  CsgTree::NodeId add_nodes(CsgTree& tree, unsigned depth, const MakeLeaf& make_leaf) {
    if (depth == 0 || below(5) == 0) {
      return tree.add(make_leaf());
    }
    std::vector<CsgTree::NodeId> operands;
    const unsigned count = 2 + below(2);
    for (unsigned i = 0; i < count; ++i) {
      operands.push_back(add_nodes(tree, depth - 1, make_leaf));
    }
    return tree.add(static_cast<Operation>(below(3)), operands);
  }

  void add_tree(unsigned depth, const glm::dmat4& place) {
    name_object();
    CsgTree tree;
    const MaterialId material = any_material();
    const bool endless = depth > 0 && material == clear_material(material);
    const double spread = depth > 0 ? 0.7 : 0.0;
    add_nodes(tree, depth, [&] {
      const glm::dmat4 moved = glm::translate(place, vec(-spread, spread)) * bent();
      return endless && below(8) == 0 ? leaf(HalfSpace{}, moved) : leaf(any_shape(), moved);
    });
    const std::size_t leaves = tree.leaves().size();
    add_object(std::move(tree), std::vector(leaves, material));
  }

  // Boxes with integer corners, whose faces are often flush.
  void add_lattice(const glm::dmat4& place) {
    name_object();
    CsgTree tree;
    add_nodes(tree, 3, [&] {
      glm::dvec3 low;
      glm::dvec3 high;
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = below(3);
        high[axis] = low[axis] + 1 + below(2);
      }
      const glm::dmat4 within = glm::scale(place, glm::dvec3(0.5));
      return leaf(Box{.size = high - low}, glm::translate(within, 0.5 * (low + high) - 1.5));
    });
    std::vector<MaterialId> materials(tree.leaves().size());
    const bool opaque = below(2) == 0;
    const MaterialId one = any_material();
    for (MaterialId& material : materials) {
      material = opaque ? MaterialId{below(4)} : one;
    }
    add_object(std::move(tree), std::move(materials));
  }

  void add_triangles(const glm::dmat4& place) {
    SurfaceMesh mesh{.triangles = any_triangles()};
    if (below(2) == 0) {
      mesh.triangles.triangles.pop_back();  // open
      mesh.triangles.faces.pop_back();
    }
    if (below(2) == 0) {  // rounded off
      for (const glm::dvec3& p : mesh.triangles.positions) {
        mesh.normals.emplace_back(glm::normalize(p + glm::dvec3(0.1 * p.y, 0.0, 0.2 * p.x)));
      }
    }
    add_mesh(std::move(mesh), place, clear_material(any_material()));
  }

  // Balls in a ball, each of its own glass, the last of anything.
  void add_nest(const glm::dvec3& at) {
    double radius = between(0.8, 1.4);
    const unsigned shells = 1 + below(3);
    for (unsigned i = 0; i <= shells; ++i) {
      const MaterialId glass{i == shells ? below(10) : std::array{4u, 5u, 8u}[below(3)]};
      const double side = 2 * radius / std::sqrt(3.0);
      const glm::dmat4 place = glm::translate(glm::dmat4(1.0), at);
      if (below(3) == 0) {
        add_solid(Box{.size = glm::dvec3(side)}, glm::rotate(place, between(0, 3), {1, 2, 3}),
                  glass);
        radius = side / 2;
      } else {
        add_solid(Sphere{.radius = radius}, place, glass);
      }
      radius *= between(0.5, 0.9);
    }
  }
};

}  // namespace

Scene random_scene(unsigned seed) { return Maker(seed)(); }

}  // namespace raycat::reference
