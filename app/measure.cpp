#include "tracer/measure.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "app/command.hpp"
#include "app/report.hpp"

namespace raycat::app {
namespace {

using Json = nlohmann::ordered_json;

struct MeasureOptions {
  CommonOptions common;
  std::uint64_t rays = default_measure_rays;
};

Json vector(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

void put(Json& to, const char* name, const std::optional<Estimate>& estimate) {
  to[name] = estimate ? Json(estimate->value) : Json();
  to[fmt::format("{}_stderr", name)] = estimate ? Json(estimate->error) : Json();
}

void put_all(Json& to, const Measurement& found) {
  put(to, "volume", found.volume);
  put(to, "area", found.area);
  to["centroid"] = found.centroid ? vector(found.centroid->value) : Json();
  to["centroid_stderr"] = found.centroid ? vector(found.centroid->error) : Json();
  to["bounds"] = to_json(found.bounds);
  to["bounds_error"] = found.bounds.empty() ? Json()
                                            : Json{{"min", vector(found.bounds_min_error)},
                                                   {"max", vector(found.bounds_max_error)}};
}

std::vector<std::string> names(const SurfaceTable& surfaces) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < surfaces.objects(); ++i) {
    out.push_back(surfaces.name(ObjectId{static_cast<std::uint32_t>(i)}));
  }
  return out;
}

Json to_json(const SceneMeasurement& found, const std::vector<std::string>& names,
             const std::vector<std::string>& warnings) {
  Json all;
  put_all(all, found.total);
  all["rays"] = found.rays;
  Json objects = Json::array();
  for (std::size_t i = 0; i < names.size(); ++i) {
    Json object{{"name", names[i]}};
    put_all(object, found.objects[i]);
    objects.push_back(std::move(object));
  }
  all["objects"] = std::move(objects);
  all["warnings"] = warnings;
  return all;
}

// Decimals up to the second digit of the error.
std::string text_of(double value, double error) {
  const double decimals = error > 0.0 ? 1.0 - std::floor(std::log10(error)) : 99.0;
  if (decimals > 9.0 || std::abs(value) >= 1e9) {
    return fmt::format("{:.9g} +- {:.2g}", value + 0.0, error);
  }
  const int shown = std::max(0, static_cast<int>(decimals));
  const std::string text = fmt::format("{:.{}f} +- {:.{}f}", value, shown, error, shown);
  const bool is_minus_zero =
      text.starts_with('-') && text.find_first_of("123456789") > text.find(' ');
  return is_minus_zero ? text.substr(1) : text;
}

std::string text_of(const std::optional<Estimate>& estimate) {
  return estimate ? text_of(estimate->value, estimate->error) : "none";
}

// Rays find a corner at 0 but for rounding.
std::string corner(const glm::dvec3& point, double size) {
  std::string text;
  for (int k = 0; k < 3; ++k) {
    text += fmt::format("{}{:.6g}", k == 0 ? "" : ", ",
                        std::abs(point[k]) < 1e-9 * size ? 0.0 : point[k]);
  }
  return text;
}

void print_table(const SceneMeasurement& found, const std::vector<std::string>& names) {
  const auto block = [](const std::string& name, const Measurement& one) {
    print(printable(name));
    print(fmt::format("  volume    {}", text_of(one.volume)));
    print(fmt::format("  area      {}", text_of(one.area)));
    if (one.centroid) {
      std::string text;
      for (int k = 0; k < 3; ++k) {
        text += fmt::format("{}{}", k == 0 ? "" : ", ",
                            text_of(one.centroid->value[k], one.centroid->error[k]));
      }
      print(fmt::format("  centroid  {}", text));
    }
    if (!one.bounds.empty()) {
      const double size = glm::length(one.bounds.half_size());
      print(fmt::format("  bounds    {} to {}", corner(one.bounds.min, size),
                        corner(one.bounds.max, size)));
    }
  };
  for (std::size_t i = 0; i < names.size(); ++i) {
    block(names[i], found.objects[i]);
  }
  block(fmt::format("all objects united, {} rays", found.rays), found.total);
}

void measure(const MeasureOptions& options) {
  SceneFile file = load(options.common);
  const SceneMeasurement found = raycat::measure(file.scene, options.rays, options.common.threads);
  const std::vector<std::string> objects = names(file.scene.surfaces);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!found.objects[i].problem.empty()) {
      file.warnings.push_back(
          fmt::format("'{}' has no volume: {}", objects[i], found.objects[i].problem));
    }
  }
  if (options.common.json) {
    print(dump(to_json(found, objects, file.warnings)));
  } else {
    print_table(found, objects);
  }
  if (!options.common.quiet) {
    warn(file.warnings);
  }
}

}  // namespace

void add_measure(CLI::App& app) {
  auto options = std::make_shared<MeasureOptions>();
  CLI::App* command = app.add_subcommand(
      "measure", "Measure the volume, area, centroid and bounds of each object by casting rays");
  add_common(*command, options->common);
  command->add_option("--rays", options->rays, "Rays, shared out among the objects")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 32))
      ->capture_default_str();
  command->callback([options] { measure(*options); });
}

}  // namespace raycat::app
