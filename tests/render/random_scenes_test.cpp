// What is true of the methods, on scenes that nobody chose.

#include <algorithm>
#include <map>
#include <string>

#include <catch2/catch.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <rapidcheck.h>

#include "categories/recode.hpp"
#include "edges/comparison.hpp"
#include "edges/edge_map.hpp"
#include "render/render.hpp"
#include "support/random_trees.hpp"
#include "support/scenes.hpp"

namespace raycat {
namespace {

double draw_between(double low, double high) {
  return low + (high - low) * draw_below(1001) / 1000;
}

glm::dmat4 draw_place() {
  const glm::dmat4 moved = at(draw_between(-2, 2), draw_between(0, 2), draw_between(-2, 2));
  return glm::rotate(moved, draw_between(0, 3), glm::dvec3(0.3, 1, 0.2));
}

Shape draw_shape() {
  if (draw_below(2) == 0) {
    return Sphere{.radius = draw_between(0.3, 1.2)};
  }
  return Box{.size = {draw_between(0.4, 2), draw_between(0.4, 2), draw_between(0.4, 2)}};
}

// Spheres, boxes and a drilled ball, of mirror, glass and stone, perhaps on a floor.
Scene draw_scene() {
  SceneBuilder builder;
  const std::vector<MaterialId> materials{
      builder.material({.diffuse = {0.7f, 0.6f, 0.5f}}),
      builder.material({.diffuse = glm::vec3(0.1f), .reflection = glm::vec3(0.8f)}),
      builder.material(
          {.reflection = glm::vec3(0.1f), .transmission = glm::vec3(0.8f), .ior = 1.5f}),
      builder.material({.transmission = glm::vec3(0.9f), .ior = 0.75f})};
  const auto draw_material = [&] { return materials[draw_below(materials.size())]; };
  const int shapes = 2 + draw_below(4);
  for (int i = 0; i < shapes; ++i) {
    builder.shape("shape " + std::to_string(i), draw_shape(), draw_place(), draw_material());
  }
  if (draw_below(2) == 0) {
    const glm::dmat4 place = draw_place();
    builder.pair("drilled", Operation::difference, Sphere{.radius = 1.0}, place,
                 Cylinder{.height = 3.0, .radius_top = 0.4, .radius_bottom = 0.4}, place,
                 draw_material());
  }
  if (draw_below(4) != 0) {
    builder.shape("floor", HalfSpace{}, at(0, -0.5, 0), draw_material());
  }
  const int lights = draw_below(3);
  for (int i = 0; i < lights; ++i) {
    builder.light({.position = {draw_between(-5, 5), draw_between(2, 6), draw_between(-5, 5)}});
  }
  return builder.take();
}

constexpr int size = 24;
const Camera view = look_at({0.5, 2.5, 7}, {0, 0.7, 0}, {0, 1, 0});

RenderSettings settings(Method method = Method::heap, const Detail& detail = {}) {
  return {.width = size, .height = size, .levels = 6, .method = method, .detail = detail};
}

// Are these the same samples with the same words?
bool same(const CategoryImage& a, const CategoryImage& b) {
  if (a.samples != b.samples || a.table.size() != b.table.size()) {
    return false;
  }
  for (std::uint32_t id = 0; id < a.table.size(); ++id) {
    if (!std::ranges::equal(a.table.words(CategoryId{id}), b.table.words(CategoryId{id}))) {
      return false;
    }
  }
  return true;
}

TEST_CASE("one trace recoded at a lower level of detail is a rendering at that level",
          "[render][recode]") {
  CHECK(rc::check([] {
    const Scene scene = draw_scene();
    const Accel accel(scene);
    const Rendering full = render(accel, view, settings());
    CategoryTrees trees(full.categories);
    const Detail detail{.levels = 1 + draw_below(6),
                        .lights = draw_below(2) == 0,
                        .ids = static_cast<Granularity>(draw_below(3))};
    for (const Method method : {Method::heap, Method::string, Method::primes, Method::godel}) {
      const Rendering direct = render(accel, view, settings(method, detail));
      RC_ASSERT(same(recode(trees, detail, scene.surfaces, *direct.categories.encoder),
                     direct.categories));
    }
  }));
}

TEST_CASE("two samples have one heap category exactly when their ray trees are equal",
          "[render][heap]") {
  CHECK(rc::check([] {
    const Scene scene = draw_scene();
    const Accel accel(scene);
    const CategoryImage image = render(accel, view, settings()).categories;
    const ImagePlane plane(view, size, size);
    TraceScratch scratch;
    std::map<CategoryId, RayTree> tree_of;
    std::vector<RayTree> trees;
    for (int y = 0; y <= size; ++y) {
      for (int x = 0; x <= size; ++x) {
        RayTree tree;
        trace(accel, plane.sample_ray(x, y), 6, tree, scratch);
        const auto [known, added] = tree_of.try_emplace(image.at(x, y), tree);
        RC_ASSERT((known->second == tree));  // one category, one tree
        if (added) {
          RC_ASSERT(std::ranges::find(trees, tree) == trees.end());  // one tree, one category
          trees.push_back(tree);
        }
      }
    }
    RC_ASSERT(trees.size() == image.table.size());
  }));
}

TEST_CASE("the heap method finds every edge that another method finds", "[render][methods]") {
  CHECK(rc::check([] {
    const Scene scene = draw_scene();
    const Accel accel(scene);
    const Rendering full = render(accel, view, settings());
    const CategoryImage& heap = full.categories;
    CategoryTrees trees(heap);
    const EdgeMap true_edges = detect_edges(heap);
    RC_CLASSIFY(heap.table.size() > 50, "over 50 categories");
    for (const Method method : {Method::string, Method::primes, Method::godel}) {
      const Encoder to = make_encoder(method, extent(scene, {}, 6));
      const CategoryImage other = recode(trees, {}, scene.surfaces, to);
      const EdgeMap edges = detect_edges(other);
      for (std::size_t i = 0; i < edges.pixels.size(); ++i) {
        RC_ASSERT(edges.pixels[i] <= true_edges.pixels[i]);
      }
      const Comparison found = compare(other, heap);
      RC_CLASSIFY(found.false_equalities > 0, std::string(name(method)) + " fails");
      RC_ASSERT(found.edge_pixels + found.missed == true_edges.count());
      RC_ASSERT(found.false_equalities >= found.missed);
      RC_ASSERT(found.distinct <= heap.table.size());
      // Compared the other way round, it is the heap method that never takes two for one.
      RC_ASSERT(compare(heap, other).false_equalities == 0u);
    }
    const Comparison itself = compare(heap, heap);
    RC_ASSERT(itself.missed + itself.false_equalities == 0u);
  }));
}

TEST_CASE("where nothing refracts the string method is the heap method", "[render][methods]") {
  CHECK(rc::check([] {
    Scene scene = draw_scene();
    for (Material& material : scene.materials) {
      material.transmission = glm::vec3(0.0f);
    }
    const Accel accel(scene);
    const CategoryImage heap = render(accel, view, settings()).categories;
    for (const Method method : {Method::string, Method::godel}) {
      RC_ASSERT((render(accel, view, settings(method)).categories.samples == heap.samples));
    }
  }));
}

}  // namespace
}  // namespace raycat
