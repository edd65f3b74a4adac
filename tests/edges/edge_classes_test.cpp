#include "edges/edge_classes.hpp"

#include <map>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "edges/edge_map.hpp"

namespace raycat {
namespace {

constexpr std::uint8_t object = 1, primitive = 2, face = 4, shadow = 8, reflection = 16,
                       refraction = 32;

// Object 0: primitive 0 of faces 0 to 5, primitive 1 of faces 6 and 7. Object 1: primitive 2 of
// face 8. Object 2: primitive 3 of faces 9 and 10.
SurfaceTable surfaces() {
  SurfaceTable table;
  table.add_object("part");
  table.add_primitive("box", 6);
  table.add_primitive("hole", 2);
  table.add_object("ball");
  table.add_primitive("ball", 1);
  table.add_object("floor");
  table.add_primitive("floor", 2);
  return table;
}

const Encoder packed = PackedHeap(PackedHeap::limits);

RayNode node(HeapPosition position, std::uint32_t surface, LightMask lights = 0) {
  return {.position = position, .lights = lights, .surface = SurfaceId{surface}};
}

CategoryImage image_of(int width, int height, const std::vector<RayTree>& trees,
                       const Encoder& heap = packed) {
  CategoryImage image{.width = width, .height = height, .encoder = heap};
  CategoryWords words;
  for (const RayTree& tree : trees) {
    encode(heap, tree, words);
    image.samples.push_back(image.table.intern(words));
  }
  return image;
}

EdgeClasses classes_of(const CategoryImage& image) {
  CategoryTrees trees(image);
  return classify_edges(trees, surfaces());
}

// The mask of a pixel whose sample has tree `a` and whose right neighbour has `b`.
std::uint8_t mask(const RayTree& a, const RayTree& b, Granularity ids = Granularity::face,
                  const Encoder& heap = packed) {
  CategoryImage image = image_of(1, 1, {a, b, a, a}, heap);
  image.detail.ids = ids;
  return classes_of(image).masks.at(0);
}

TEST_CASE("what differs at the root names the class", "[edges][classes]") {
  CHECK(mask({node(1, 0)}, {node(1, 0)}) == 0);
  CHECK(mask({node(1, 0)}, {node(1, 8)}) == object);
  CHECK(mask({node(1, 0)}, {node(1, 6)}) == primitive);
  CHECK(mask({node(1, 0)}, {node(1, 5)}) == face);
  CHECK(mask({node(1, 9)}, {node(1, 10)}) == face);
  CHECK(mask({node(1, 0, 1)}, {node(1, 0, 2)}) == shadow);
  CHECK(mask({}, {node(1, 0)}) == object);
}

TEST_CASE("another surface under other lights is no shadow", "[edges][classes]") {
  CHECK(mask({node(1, 0, 1)}, {node(1, 1, 0)}) == face);
  CHECK(mask({node(1, 0, 1)}, {node(1, 8, 0)}) == object);
}

TEST_CASE("trees of the paper's figures differ as drawn", "[edges][classes]") {
  // Fig. 2, its spheres A and B being the ball and the floor. Of a, the text's ALALA has an unlit
  // root and b's BLAL a lit one.
  const RayTree a{node(2, 8, 1), node(3, 8, 1), node(1, 8, 0)};
  const RayTree b{node(3, 9, 1), node(1, 8, 1)};
  CHECK(mask(a, b) == shadow);
  CHECK(mask(b, {}) == object);
  // With the root lit in both, the refracted ray is in a alone, and the reflected one meets A or B.
  const RayTree a_lit{node(2, 8, 1), node(3, 8, 1), node(1, 8, 1)};
  CHECK(mask(a_lit, b) == (object | reflection | refraction));
  // Fig. 3: BA and AB.
  CHECK(mask({node(3, 9), node(1, 8)}, {node(3, 8), node(1, 9)}) == object);
  // Fig. 5: 4A2BL1C and 7A3BL1C. Only their second level counts.
  CHECK(mask({node(4, 8), node(2, 9, 1), node(1, 0)}, {node(7, 8), node(3, 9, 1), node(1, 0)}) ==
        (object | reflection | refraction));
}

TEST_CASE("the way to the node names the branches", "[edges][classes]") {
  const auto below = [](std::vector<HeapPosition> way, std::uint32_t surface, LightMask lights) {
    RayTree tree{node(way.back(), surface, lights)};
    for (way.pop_back(); !way.empty(); way.pop_back()) {
      tree.push_back(node(way.back(), 8, 1));
    }
    return tree;
  };
  CHECK(mask(below({1, 3}, 9, 1), below({1, 3}, 9, 0)) == (shadow | reflection));
  CHECK(mask(below({1, 2}, 9, 1), below({1, 2}, 10, 1)) == (face | refraction));
  CHECK(mask(below({1, 3, 7}, 0, 1), below({1, 3, 7}, 6, 1)) == (primitive | reflection));
  CHECK(mask(below({1, 2, 4}, 0, 1), below({1, 2, 4}, 9, 1)) == (object | refraction));
  CHECK(mask(below({1, 2, 5}, 9, 1), below({1, 2, 5}, 9, 2)) == (shadow | reflection | refraction));
  CHECK(mask(below({1, 3, 6}, 9, 1), below({1, 3, 6}, 9, 2)) == (shadow | reflection | refraction));
}

TEST_CASE("only the first level that differs counts, and all of it", "[edges][classes]") {
  const RayTree tree{node(4, 0, 1), node(2, 9, 1), node(6, 8, 1), node(3, 6, 1), node(1, 8, 1)};
  // The root's lights hide what is below.
  CHECK(mask(tree, {node(3, 7, 0), node(1, 8, 0)}) == shadow);
  // Both nodes of level 2: another face in the mirror, other lights through the glass. Level 3
  // has other objects, which do not count.
  CHECK(mask(tree, {node(4, 9, 1), node(2, 9, 0), node(6, 9, 1), node(3, 7, 1), node(1, 8, 1)}) ==
        (shadow | face | reflection | refraction));
  // A node that is gone takes the nodes below with it.
  CHECK(mask(tree, {node(4, 0, 1), node(2, 9, 1), node(1, 8, 1)}) == (object | reflection));
  // Level 3 alone.
  CHECK(mask(tree, {node(4, 3, 1), node(2, 9, 1), node(6, 8, 1), node(3, 6, 1), node(1, 8, 1)}) ==
        (face | refraction));
}

TEST_CASE("surfaces differ by no more than they are told apart", "[edges][classes]") {
  // As objects 0 to 2 and as primitives 0 to 3.
  CHECK(mask({node(1, 0)}, {node(1, 1)}, Granularity::object) == object);
  CHECK(mask({node(1, 0)}, {node(1, 1)}, Granularity::primitive) == primitive);
  CHECK(mask({node(1, 1)}, {node(1, 2)}, Granularity::primitive) == object);
  CHECK(mask({node(1, 2)}, {node(1, 3)}, Granularity::primitive) == object);
}

TEST_CASE("an untold surface is another object's", "[edges][classes]") {
  CHECK(mask({node(1, 11)}, {node(1, 10)}, Granularity::face) == object);
  CHECK(mask({node(1, 0)}, {node(1, 4)}, Granularity::primitive) == object);
  CHECK(mask({node(1, 3)}, {node(1, 2)}, Granularity::object) == object);
  CHECK(mask({node(1, 11, 1)}, {node(1, 11, 2)}, Granularity::face) == shadow);
}

TEST_CASE("a pixel has the classes of its three neighbours", "[edges][classes]") {
  const RayTree here{node(1, 0, 1)}, lit{node(1, 0, 2)}, turned{node(1, 1, 1)}, other{node(1, 8)};
  const EdgeClasses classes = classes_of(image_of(2, 1, {here, lit, here, turned, other, here}));
  // Left pixel: right of it `lit`, below `turned`, across `other`. Right pixel: `here`, `other`,
  // `here` against `lit`.
  CHECK(classes.masks == std::vector<std::uint8_t>{shadow | face | object, shadow | object});
  CHECK(classes.counts() == std::array<std::uint64_t, 6>{2, 0, 1, 2, 0, 0});
}

TEST_CASE("wide categories are classified like packed ones", "[edges][classes]") {
  const Encoder wide = WideHeap(WideHeap::limits);
  const HeapPosition last = ~HeapPosition{0};  // level 64, by reflections alone
  CHECK(mask({node(last, 0)}, {node(last, 1)}, Granularity::face, wide) == (face | reflection));
  CHECK(mask({node(last, 0)}, {}, Granularity::face, wide) == (object | reflection));
  CHECK(mask({node(HeapPosition{1} << 63, 9, 1)}, {node(HeapPosition{1} << 63, 9, 2)},
             Granularity::face, wide) == (shadow | refraction));
}

TEST_CASE("categories that are no trees cannot be classified", "[edges][classes]") {
  const Encoder string = IdString(Extent{.levels = 8, .lights = 8, .surfaces = 11});
  CHECK_THROWS_AS(mask({node(1, 0)}, {node(1, 1)}, Granularity::face, string), std::logic_error);
}

TEST_CASE("each class has a name", "[edges][classes]") {
  std::string names;
  for (const EdgeClass each : all_edge_classes) {
    names += std::string(name(each)) + " ";
  }
  CHECK(names == "object primitive face shadow reflection refraction ");
}

RayTree random_tree() {
  RayTree tree;
  for (HeapPosition position = 15; position > 0; --position) {
    if (*rc::gen::inRange(0, 4) != 0) {
      tree.push_back(node(position, *rc::gen::element<std::uint32_t>(0, 1, 6, 8, 9, 11),
                          *rc::gen::inRange<LightMask>(0, 2)));
    }
  }
  return tree;
}

// A tree that differs from `tree` in a node or two, most often.
RayTree altered(RayTree tree) {
  for (int changes = *rc::gen::inRange(0, 3); changes > 0 && !tree.empty(); --changes) {
    const auto changed =
        tree.begin() + static_cast<std::ptrdiff_t>(*rc::gen::inRange<std::size_t>(0, tree.size()));
    switch (*rc::gen::inRange(0, 3)) {
      case 0:
        changed->lights ^= 1;
        break;
      case 1:
        changed->surface = SurfaceId{*rc::gen::element<std::uint32_t>(0, 1, 6, 8, 9, 11)};
        break;
      default:
        tree.erase(changed);  // the others stay in order, as in all trees that are recorded
    }
  }
  return tree;
}

// The definition, level by level, with no regard to speed.
std::uint8_t defined(const RayTree& a, const RayTree& b) {
  const SurfaceTable table = surfaces();
  std::map<HeapPosition, RayNode> in_a, in_b;
  for (const RayNode& each : a) {
    in_a[each.position] = each;
  }
  for (const RayNode& each : b) {
    in_b[each.position] = each;
  }
  unsigned result = 0;
  for (HeapPosition first = 1; first <= 8 && result == 0; first *= 2) {
    for (HeapPosition p = first; p < 2 * first; ++p) {
      unsigned difference = 0;
      if (in_a.contains(p) != in_b.contains(p)) {
        difference = object;
      } else if (in_a.contains(p)) {
        const RayNode& na = in_a[p];
        const RayNode& nb = in_b[p];
        const bool untold_a = na.surface == SurfaceId{11}, untold_b = nb.surface == SurfaceId{11};
        if (untold_a != untold_b) {
          difference = object;
        } else if (!untold_a && table.object(na.surface) != table.object(nb.surface)) {
          difference = object;
        } else if (!untold_a && table.primitive(na.surface) != table.primitive(nb.surface)) {
          difference = primitive;
        } else if (na.surface != nb.surface) {
          difference = face;
        } else if (na.lights != nb.lights) {
          difference = shadow;
        }
      }
      for (HeapPosition up = p; difference != 0 && up > 1; up /= 2) {
        result |= up % 2 == 1 ? reflection : refraction;
      }
      result |= difference;
    }
  }
  return static_cast<std::uint8_t>(result);
}

TEST_CASE("classes are as defined, whichever tree comes first", "[edges][classes]") {
  CHECK(rc::check("random trees", [] {
    const RayTree a = random_tree();
    const RayTree b = altered(a);
    RC_ASSERT(mask(a, b) == defined(a, b));
    RC_ASSERT(mask(b, a) == mask(a, b));
  }));
}

TEST_CASE("a mask is 0 exactly off edges, and has a way of differing", "[edges][classes]") {
  CHECK(rc::check("random images", [] {
    std::vector<RayTree> trees{random_tree()};
    trees.push_back(altered(trees[0]));
    trees.push_back(altered(trees[0]));
    std::vector<RayTree> samples;
    for (int i = 0; i < 20; ++i) {
      samples.push_back(trees[*rc::gen::inRange<std::size_t>(0, 3)]);
    }
    const CategoryImage image = image_of(4, 3, samples);
    const EdgeClasses classes = classes_of(image);
    const EdgeMap edges = detect_edges(image);
    std::array<std::uint64_t, 6> counts{};
    for (std::size_t i = 0; i < edges.pixels.size(); ++i) {
      RC_ASSERT((classes.masks[i] != 0) == (edges.pixels[i] != 0));
      RC_ASSERT((classes.masks[i] == 0 || classes.masks[i] % 16 != 0));
      for (std::size_t each = 0; each < 6; ++each) {
        counts[each] += classes.masks[i] >> each & 1u;
      }
    }
    RC_ASSERT(classes.counts() == counts);
  }));
}

}  // namespace
}  // namespace raycat
