// Whose surface is it where several leaves are crossed at one place (docs/design.md, Coincident
// surfaces)?

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <rapidcheck.h>

#include "csg/solid.hpp"
#include "tests/csg/random_models.hpp"

namespace raycat {
namespace {

// Boxes on an integer lattice have flush faces everywhere, so ties are the rule.
TEST_CASE("ids do not depend on the order of operands", "[csg][solid][tie]") {
  CHECK(rc::check("shuffles", [](unsigned seed) {
    Model model = any_model(seed, integer_box);
    const Solid solid = solid_of(model);
    Random random(seed);
    shuffle(model.expression, random);
    const Solid shuffled = solid_of(model);
    for (int i = 0; i < 30; ++i) {
      const Ray ray = any_ray(random);
      RC_ASSERT(surfaces(solid, ray) == surfaces(shuffled, ray));
    }
  }));
}

TEST_CASE("ids do not depend on a rigid motion", "[csg][solid][tie]") {
  CHECK(rc::check("motions", [](unsigned seed) {
    const Model model = any_model(seed, integer_box);
    Random random(seed);
    const glm::dmat4 motion =
        glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(uniform(random, -9, 9), 2, 1)),
                    uniform(random, 0, 6), glm::normalize(glm::dvec3(1, uniform(random, 0, 1), 2)));
    Model moved = model;
    for (CsgLeaf& leaf : moved.leaves) {
      leaf.shape =
          PlacedShape(leaf.shape.shape(), Affine(motion * leaf.shape.transform().matrix()));
    }
    const Solid here = solid_of(model);
    const Solid there = solid_of(moved);
    for (int i = 0; i < 30; ++i) {
      const Ray ray = any_ray(random);
      const Ray moved_ray{.origin = glm::dvec3(motion * glm::dvec4(ray.origin, 1.0)),
                          .direction = glm::dmat3(motion) * ray.direction};
      const auto a = surfaces(here, ray);
      const auto b = surfaces(there, moved_ray);
      RC_ASSERT(a.size() == b.size());
      for (std::size_t k = 0; k < a.size(); ++k) {
        RC_ASSERT(a[k].second == b[k].second);
        RC_ASSERT(std::abs(a[k].first - b[k].first) < 1e-9);
      }
    }
  }));
}

TEST_CASE("a flush difference leaves no skin", "[csg][solid][tie]") {
  // The cutter's top is the box's own top: a slot open upwards.
  const Model slot = two(Operation::difference, PlacedShape(Box{.size = {4, 2, 4}}, placed({})),
                         PlacedShape(Box{.size = {1, 1, 6}}, placed({0, 0.5, 0})));
  const auto found = surfaces(solid_of(slot), {.origin = {0.2, 5, 0.1}, .direction = {0, -1, 0}});
  REQUIRE(found.size() == 2);
  CHECK(found[0].first == Approx(5.0));        // the slot's floor, at y = 0
  CHECK(found[0].second == SurfaceId{6 + 2});  // the cutter's lower face
  CHECK(found[1].first == Approx(6.0));
  CHECK(found[1].second == SurfaceId{2});  // the box's lower face
}

TEST_CASE("identical operands are one solid with the first one's ids", "[csg][solid][tie]") {
  const auto box = [] { return PlacedShape(Box{.size = {2, 2, 2}}, placed({})); };
  const Ray ray{.origin = {-5, 0.3, 0.2}, .direction = {2, 0, 0}};
  using Found = std::vector<std::pair<double, SurfaceId>>;
  const Found first{{2.0, SurfaceId{0}}, {3.0, SurfaceId{1}}};
  CHECK(surfaces(solid_of(two(Operation::set_union, box(), box())), ray) == first);
  CHECK(surfaces(solid_of(two(Operation::intersection, box(), box())), ray) == first);
  CHECK(surfaces(solid_of(two(Operation::difference, box(), box())), ray).empty());
}

TEST_CASE("faces that touch from both sides vanish in a union", "[csg][solid][tie]") {
  const Model halves = two(Operation::set_union, PlacedShape(Box{.size = {1, 1, 1}}, placed({})),
                           PlacedShape(Box{.size = {1, 1, 1}}, placed({1, 0, 0})));
  const auto found = surfaces(solid_of(halves), {.origin = {-3, 0.1, 0.1}, .direction = {1, 0, 0}});
  REQUIRE(found.size() == 2);
  CHECK(found[0].second == SurfaceId{0});
  CHECK(found[1].second == SurfaceId{6 + 1});
}

TEST_CASE("a subtracted surface is reported only where no kept one is", "[csg][solid][tie]") {
  // Intersected, the first box and the complement of the second share the plane x = 0: the kept
  // box's face is the responsible one.
  const Model cut =
      two(Operation::difference, PlacedShape(Box{.size = {2, 2, 2}}, placed({1, 0, 0})),
          PlacedShape(Box{.size = {2, 4, 4}}, placed({-1, 0, 0})));
  const auto found = surfaces(solid_of(cut), {.origin = {-5, 0.1, 0}, .direction = {1, 0, 0}});
  REQUIRE(found.size() == 2);
  CHECK(found[0].second == SurfaceId{0});
}

// The rule as docs/design.md words it (Coincident surfaces), by asking what holds a point before
// the place and one behind it.
class Responsible {
 public:
  Responsible(const Model& model, const glm::dvec3& before, const glm::dvec3& after)
      : model_(model), before_(before), after_(after) {
    look(model.expression, false);
  }

  // The least (is subtracted, first face) of the responsible leaves.
  std::optional<std::pair<bool, std::uint32_t>> best() const { return best_; }

 private:
  bool changes(const Expression& e) const {
    return contains(e, model_.leaves, before_) != contains(e, model_.leaves, after_);
  }

  void look(const Expression& e, bool subtracted) {
    if (!changes(e)) {
      return;
    }
    if (e.operands.empty()) {
      const std::pair rank(subtracted,
                           static_cast<std::uint32_t>(model_.leaves[e.leaf].first_face));
      best_ = best_ ? std::min(*best_, rank) : rank;
    }
    for (const Expression& operand : e.operands) {
      const bool cut = e.operation == Operation::difference && &operand != &e.operands.front();
      look(operand, subtracted != cut);
    }
  }

  const Model& model_;
  glm::dvec3 before_;
  glm::dvec3 after_;
  std::optional<std::pair<bool, std::uint32_t>> best_;
};

TEST_CASE("the surface is that of the least responsible leaf, and not just the least",
          "[csg][tie]") {
  int boundaries = 0;
  int wrong = 0;
  int naive_wrong = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    const Model model = any_model(seed, integer_box);
    const Solid solid = solid_of(model);
    Solid::Scratch scratch;
    Random random(seed);
    for (int i = 0; i < 40; ++i) {
      // Through the middle of the boxes, and not along an axis: each plane has a place of its own.
      const glm::dvec3 to(uniform(random, 0, 6), uniform(random, 0, 6), uniform(random, 0, 6));
      const glm::dvec3 way(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
      const Ray ray{.origin = to - 9.0 * way, .direction = way};
      solid.cross(ray, scratch);
      for (const Boundary& boundary : scratch.boundaries) {
        constexpr double near = 1e-6;
        const Responsible rule(model, ray.at(boundary.t - near), ray.at(boundary.t + near));
        const CsgLeaf& leaf = model.leaves[boundary.leaf];
        // The tree numbers leaves as the expression does.
        REQUIRE(solid.tree().leaves()[boundary.leaf].first_face == leaf.first_face);
        ++boundaries;
        const auto first = static_cast<std::uint32_t>(leaf.first_face);
        wrong += rule.best() == std::pair(boundary.subtracted, first) ? 0 : 1;

        std::optional<std::uint32_t> least;
        for (const CsgLeaf& other : model.leaves) {
          Crossings crossings;
          other.shape.cross(ray, crossings);
          for (const Crossing& crossing : crossings) {
            if (!least && std::abs(crossing.t - boundary.t) < near) {
              least = static_cast<std::uint32_t>(other.first_face);
            }
          }
        }
        naive_wrong += least == first ? 0 : 1;
      }
    }
  }
  CAPTURE(boundaries, wrong, naive_wrong);
  CHECK(boundaries > 10'000);
  CHECK(wrong == 0);
  CHECK(naive_wrong > boundaries / 30);
}

// The 24 turns that take the axes to the axes.
std::vector<glm::dmat3> quarter_turns() {
  std::vector<glm::dmat3> turns;
  std::array axes{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      glm::dmat3 turn(0.0);
      for (int k = 0; k < 3; ++k) {
        turn[k][axes[static_cast<std::size_t>(k)]] = (signs >> k & 1) != 0 ? -1.0 : 1.0;
      }
      if (glm::determinant(turn) > 0.0) {
        turns.push_back(turn);
      }
    }
  } while (std::ranges::next_permutation(axes).found);
  return turns;
}

Model moved(Model model, const glm::dmat4& motion) {
  for (CsgLeaf& leaf : model.leaves) {
    leaf.shape = PlacedShape(leaf.shape.shape(), Affine(motion * leaf.shape.transform().matrix()));
  }
  return model;
}

TEST_CASE("no id changes under quarter turns and whole steps", "[csg][tie]") {
  const std::vector<glm::dmat3> turns = quarter_turns();
  REQUIRE(turns.size() == 24);
  CHECK(rc::check("turns", [&](unsigned seed) {
    const Model model = any_model(seed, integer_box);
    const Solid here = solid_of(model);
    for (const glm::dmat3& turn : turns) {
      Random random(seed);
      glm::dmat4 motion(turn);
      motion[3] = glm::dvec4(random() % 7, -3, 8, 1);
      const Solid there = solid_of(moved(model, motion));
      for (int i = 0; i < 10; ++i) {
        const Ray ray = any_ray(random);
        const auto a = surfaces(here, ray);
        const auto b = surfaces(there, {.origin = glm::dvec3(motion * glm::dvec4(ray.origin, 1.0)),
                                        .direction = turn * ray.direction});
        RC_ASSERT(a.size() == b.size());
        for (std::size_t k = 0; k < a.size(); ++k) {
          RC_ASSERT(a[k].second == b[k].second);
          RC_ASSERT(std::abs(a[k].first - b[k].first) < 1e-12);
        }
      }
    }
  }));
}

TEST_CASE("an operand used twice is as if used once", "[csg][tie]") {
  CHECK(rc::check("twice", [](unsigned seed) {
    const Model once = any_model(seed, integer_box);
    // The second use has ids of its own, which are higher.
    Model twice = once;
    std::vector<std::uint32_t> second(once.leaves.size());
    for (std::size_t i = 0; i < once.leaves.size(); ++i) {
      second[i] = static_cast<std::uint32_t>(twice.leaves.size());
      add_leaf(twice, once.leaves[i].shape);
    }
    const auto again = [&](const auto& self, Expression e) -> Expression {
      e.leaf = e.operands.empty() ? second[e.leaf] : 0;
      for (Expression& operand : e.operands) {
        operand = self(self, operand);
      }
      return e;
    };
    const Expression copy = again(again, once.expression);
    const Solid alone = solid_of(once);
    Random random(seed);
    for (const Operation operation :
         {Operation::set_union, Operation::intersection, Operation::difference}) {
      Model model = twice;
      model.expression = {.operation = operation, .operands = {copy, once.expression}};
      const Solid both = solid_of(model);
      for (int i = 0; i < 20; ++i) {
        const Ray ray = any_ray(random);
        if (operation == Operation::difference) {
          RC_ASSERT(surfaces(both, ray).empty());
        } else {
          RC_ASSERT(surfaces(both, ray) == surfaces(alone, ray));
        }
      }
    }
  }));
}

}  // namespace
}  // namespace raycat
