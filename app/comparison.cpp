#include "app/comparison.hpp"

#include <algorithm>
#include <optional>

#include "categories/exact_number.hpp"
#include "categories/recode.hpp"
#include "render/in_turns.hpp"

namespace raycat::app {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

std::uint64_t pixels_past(const Encoder& encoder, std::size_t bits, const CategoryImage& image,
                          const CategoryImage& exact_primes) {
  if (std::holds_alternative<GodelNumber>(encoder)) {
    return count_pixels(image, [&](auto words) { return GodelNumber::overflows(words, bits); });
  }
  if (std::holds_alternative<PrimesProduct>(encoder)) {
    return count_pixels(exact_primes, [&](auto words) {
      BigInteger number;
      import_bits(number, words.begin(), words.end(), 32);
      return (number >> bits) != 0;
    });
  }
  return 0;
}

// The products themselves, of any size, 32 bits a word.
CategoryImage exact_primes(const Rendering& heap, const Encoder& primes) {
  std::vector<std::uint32_t> factors;
  CategoryTrees trees(heap.categories);
  return recode(trees, [&](const RayTree& tree, CategoryWords& words) {
    std::get<PrimesProduct>(primes).list_factors(tree, factors);
    words.clear();
    export_bits(exact_product(factors), std::back_inserter(words), 32);
  });
}

}  // namespace

MethodTable compare_methods(const Accel& accel, const Camera& camera,
                            const RenderSettings& settings, int repetitions) {
  constexpr Method methods[] = {Method::heap, Method::string, Method::primes, Method::godel};
  MethodTable table{.pixels = static_cast<std::uint64_t>(settings.width) *
                              static_cast<std::uint64_t>(settings.height)};
  std::vector<std::optional<Rendering>> renderings(std::size(methods));
  std::vector<TimedRender> renders{[&](const RenderSettings& own) {
    RayCounts ignored;
    render_colour(accel, camera, own, ignored);
  }};
  for (std::size_t m = 0; m < std::size(methods); ++m) {
    renders.emplace_back([&, m](RenderSettings own) {
      own.method = methods[m];
      renderings[m] = render(accel, camera, own);
    });
  }
  std::vector<double> none;
  std::vector<std::vector<double>> seconds(std::size(methods));
  std::vector<std::vector<double>> ratios(std::size(methods));
  // An image with categories has a row and a column of samples more.
  const auto samples = static_cast<double>(settings.width + 1) * (settings.height + 1);
  const double more = samples / static_cast<double>(table.pixels);
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    const std::vector<double> taken = cpu_seconds_in_turns(renders, settings);
    none.push_back(taken[0]);
    for (std::size_t m = 0; m < std::size(methods); ++m) {
      seconds[m].push_back(taken[m + 1]);
      ratios[m].push_back(taken[m + 1] / more / taken[0]);
    }
  }
  table.none_seconds = median(none);

  const Rendering& heap = *renderings[0];
  const CategoryImage primes = exact_primes(heap, *renderings[2]->categories.encoder);
  for (std::size_t m = 0; m < std::size(methods); ++m) {
    const CategoryImage& own = renderings[m]->categories;
    const Encoder& encoder = *own.encoder;
    const Comparison found = compare(methods[m] == Method::primes ? primes : own, heap.categories);
    table.methods.push_back({.method = std::string(name(methods[m])),
                             .edge_pixels = found.edge_pixels,
                             .missed = found.missed,
                             .false_equalities = found.false_equalities,
                             .distinct = found.distinct,
                             .overflowed = pixels_past(encoder, 64, own, primes),
                             .overflowed_80 = pixels_past(encoder, 80, own, primes),
                             .bytes = own.bytes(),
                             .trace_seconds = median(seconds[m]),
                             .ratio_to_none = median(ratios[m])});
  }
  table.machine_word = compare(renderings[2]->categories, heap.categories);
  return table;
}

}  // namespace raycat::app
