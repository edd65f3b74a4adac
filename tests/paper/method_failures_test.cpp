// Figs. 3 and 4: scenes in which the primes product method and the string method take two
// neighbouring pixels' trees for one, where the binary heap method does not.

#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "categories/exact_number.hpp"
#include "categories/recode.hpp"
#include "edges/comparison.hpp"
#include "io/load_scene.hpp"
#include "render/render.hpp"

namespace raycat {
namespace {

using TreePair = std::pair<RayTree, RayTree>;

// A scene of assets/ at the default settings.
class Case {
 public:
  explicit Case(const std::string& name)
      : file_(load_scene(std::string(RAYCAT_ASSETS) + "/scenes/" + name + ".gltf")),
        accel_(file_.scene),
        full_(by(Method::heap)) {}

  const CategoryImage& heap() const { return full_.categories; }

  Rendering by(Method method) const {
    return render(accel_, file_.scene.cameras.front(), {.threads = 2, .method = method});
  }

  // By the products themselves, so that nothing fails for being too large for a word.
  CategoryImage by_exact_product() const {
    const PrimesProduct method(extent(file_.scene, {}, RenderSettings{}.levels));
    std::vector<std::uint32_t> factors;
    CategoryTrees trees(heap());
    return recode(trees, [&](const RayTree& tree, CategoryWords& words) {
      method.list_factors(tree, factors);
      words.clear();
      export_bits(exact_product(factors), std::back_inserter(words), 32);
    });
  }

  // The trees of neighbouring samples that `method` takes for one.
  std::vector<TreePair> confused(const CategoryImage& method) const {
    std::vector<TreePair> pairs;
    for (int y = 0; y < heap().height; ++y) {
      for (int x = 0; x < heap().width; ++x) {
        for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
          if (method.at(x, y) == method.at(x + dx, y + dy) &&
              heap().at(x, y) != heap().at(x + dx, y + dy)) {
            pairs.emplace_back(tree(x, y), tree(x + dx, y + dy));
          }
        }
      }
    }
    return pairs;
  }

  const std::string& object(const RayNode& node) const {
    return file_.scene.surfaces.name(file_.scene.surfaces.object(node.surface));
  }

 private:
  RayTree tree(int x, int y) const {
    RayTree result;
    decode(*heap().encoder, heap().table.words(heap().at(x, y)), result);
    return result;
  }

  SceneFile file_;
  Accel accel_;
  Rendering full_;
};

TEST_CASE("in fig3 the product misses the line where two mirrors meet, and strings find it",
          "[paper][fig3]") {
  const Case fig3("fig3");
  const CategoryImage exact = fig3.by_exact_product();
  const Comparison primes = compare(exact, fig3.heap());
  CHECK(primes.missed > 100);
  CHECK(primes.false_equalities > 200);
  CHECK(primes.distinct < fig3.heap().table.size());

  // The machine word does no better, and nothing else than the order of A and B is at fault.
  const CategoryImage words = fig3.by(Method::primes).categories;
  CHECK(compare(words, fig3.heap()).missed >= primes.missed);
  const std::vector<TreePair> pairs = fig3.confused(exact);
  CHECK(pairs.size() == primes.false_equalities);
  for (const auto& [a, b] : pairs) {
    REQUIRE(a.size() == 3);
    REQUIRE(b.size() == 3);
    CHECK(a[0] == b[0]);
    CHECK(fig3.object(a[1]) == fig3.object(b[2]));
    CHECK(fig3.object(a[2]) == fig3.object(b[1]));
    CHECK((std::set{fig3.object(a[1]), fig3.object(a[2])} == std::set<std::string>{"A", "B"}));
  }

  CHECK(fig3.by(Method::string).categories.samples == fig3.heap().samples);
  CHECK(fig3.by(Method::godel).categories.samples == fig3.heap().samples);
}

TEST_CASE("in fig4 strings miss the line where refraction gives way to reflection",
          "[paper][fig4]") {
  const Case fig4("fig4");
  const CategoryImage strings = fig4.by(Method::string).categories;
  const Comparison string = compare(strings, fig4.heap());
  CHECK(string.missed > 100);
  CHECK(string.false_equalities > 200);
  CHECK(string.distinct < fig4.heap().table.size());

  // C leads to the same thing by refraction in one tree and by total reflection in the other.
  const std::vector<TreePair> pairs = fig4.confused(strings);
  CHECK(pairs.size() == string.false_equalities);
  std::size_t to_wall = 0;
  for (const auto& [a, b] : pairs) {
    REQUIRE(a.size() == 2);
    REQUIRE(b.size() == 2);
    CHECK(fig4.object(a[1]) == "C");
    CHECK(a[1] == b[1]);
    CHECK(a[0].surface == b[0].surface);
    CHECK(a[0].lights == b[0].lights);
    CHECK((std::set{a[0].position, b[0].position} == std::set<HeapPosition>{2, 3}));
    to_wall += fig4.object(a[0]) == "B" && a[0].lights != 0 ? 1u : 0u;
  }
  CHECK(to_wall > 200);  // B L C, as printed but for A

  // Where strings fail, Gödel numbers and products do.
  CHECK(fig4.by(Method::godel).categories.samples == strings.samples);
  const Comparison primes = compare(fig4.by_exact_product(), fig4.heap());
  CHECK(primes.missed >= string.missed);
  CHECK(primes.false_equalities >= string.false_equalities);
}

}  // namespace
}  // namespace raycat
