#include "app/antialias_options.hpp"

#include <bit>
#include <utility>

#include <fmt/format.h>

#include "antialias/adaptive.hpp"
#include "app/command.hpp"
#include "app/help.hpp"

namespace raycat::app {
namespace {

constexpr int most_samples_a_side = 64;
constexpr int default_side = 4;
constexpr float default_threshold = 0.1f;

std::string_view name(AntialiasMethod method) {
  static constexpr std::string_view names[] = {"uniform", "threshold", "whitted", "category",
                                               "adaptive"};
  return names[static_cast<std::size_t>(method)];
}

bool halves(const AntialiasOptions& options) {
  return options.method == AntialiasMethod::whitted || options.recursive;
}

int depth(const AntialiasOptions& options) {
  return std::countr_zero(static_cast<unsigned>(options.samples.value_or(default_side)));
}

}  // namespace

void add_antialias(CLI::App& command, AntialiasOptions& options) {
  start_group(command, groups::picture);
  add_choice<std::optional<AntialiasMethod>>(
      command, "--aa", options.method,
      {{"none", std::nullopt},
       {"uniform", AntialiasMethod::uniform},
       {"threshold", AntialiasMethod::threshold},
       {"whitted", AntialiasMethod::whitted},
       {"category", AntialiasMethod::category},
       {"adaptive", AntialiasMethod::adaptive}},
      "Antialiasing of the picture: none (default), uniform, threshold, whitted, category (the "
      "paper's) or adaptive (ours)")
      ->type_name("METHOD");
  command
      .add_option("--samples", options.samples,
                  fmt::format("--aa uniform, threshold, category, whitted: samples a side of a "
                              "pixel at most; {} by default",
                              default_side))
      ->type_name("N")
      ->check(CLI::Range(1, most_samples_a_side));
  command
      .add_option("--threshold", options.threshold,
                  fmt::format("--aa threshold, whitted: how far linear colours (0 to 1) must be "
                              "apart; {} by default",
                              default_threshold))
      ->type_name("T")
      ->check(number_in(0.0, 1.0));
  command
      .add_option(
          "--quality", options.quality,
          "--aa adaptive: the error of a pixel's colour that is left alone; 0.01 by default")
      ->type_name("E")
      ->check(number_in(1e-5, 1.0));
  command
      .add_option("--budget", options.budget,
                  "--aa adaptive: rays a pixel to spend, in place of --quality, on what may be "
                  "off most, first")
      ->type_name("R")
      ->check(number_in(1.0, 1024.0))
      ->excludes("--quality");
  add_choice<std::optional<Filter>>(command, "--filter", options.filter,
                                    {{"box", Filter::box},
                                     {"tent", Filter::tent},
                                     {"gaussian", Filter::gaussian},
                                     {"mitchell", Filter::mitchell}},
                                    "--aa uniform, adaptive: how pixels are put together: box "
                                    "(default), tent, gaussian or mitchell")
      ->type_name("FILTER");
  command.add_flag("--by-area", options.by_area,
                   "--aa whitted: weigh differences with the area that they are of");
  command.add_flag(
      "--recursive", options.recursive,
      "--aa category: subdivide pixels in four where categories differ, again and again");
  command.add_flag("--colour-only", options.colour_only,
                   "--aa adaptive: decide by colours alone, to see what categories add");
}

void require_antialias(const AntialiasOptions& options) {
  const auto require = [&](bool given, const char* option,
                           std::initializer_list<AntialiasMethod> methods) {
    for (const AntialiasMethod method : methods) {
      given = given && options.method != method;
    }
    if (given) {
      throw UsageError(options.method ? fmt::format("{}: --aa {} has no use for it", option,
                                                    name(*options.method))
                                      : fmt::format("{}: give --aa with it", option));
    }
  };
  using enum AntialiasMethod;
  require(options.samples.has_value(), "--samples", {uniform, threshold, whitted, category});
  require(options.threshold.has_value(), "--threshold", {threshold, whitted});
  require(options.quality.has_value(), "--quality", {adaptive});
  require(options.budget.has_value(), "--budget", {adaptive});
  require(options.filter.has_value(), "--filter", {uniform, adaptive});
  require(options.by_area, "--by-area", {whitted});
  require(options.recursive, "--recursive", {category});
  require(options.colour_only, "--colour-only", {adaptive});
  if (halves(options) &&
      !std::has_single_bit(static_cast<unsigned>(options.samples.value_or(default_side)))) {
    throw UsageError(
        fmt::format("--samples {}: where pixels are subdivided in four it must be a power of two",
                    *options.samples));
  }
}

AntialiasedPicture antialias(Sampler& sampler, AntialiasSettings settings,
                             const AntialiasOptions& options) {
  settings.filter = options.filter.value_or(Filter::box);
  const int side = options.samples.value_or(default_side);
  const float threshold = options.threshold.value_or(default_threshold);
  switch (*options.method) {
    case AntialiasMethod::uniform:
      return antialias_uniformly(sampler, settings, side);
    case AntialiasMethod::threshold:
      return antialias_selected(sampler, settings, by_colour(threshold), side);
    case AntialiasMethod::whitted:
      return antialias_recursively(sampler, settings,
                                   subdivide_by_colour(threshold, options.by_area), depth(options));
    case AntialiasMethod::category:
      return options.recursive
                 ? antialias_recursively(sampler, settings, subdivide_by_category(), depth(options))
                 : antialias_selected(sampler, settings, by_category(), side);
    case AntialiasMethod::adaptive:
      break;
  }
  return antialias_adaptively(sampler, settings,
                              {.error = options.quality.value_or(AdaptiveSettings().error),
                               .budget = options.budget,
                               .categories = !options.colour_only});
}

}  // namespace raycat::app
