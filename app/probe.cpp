#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "app/command.hpp"
#include "app/report.hpp"
#include "app/view.hpp"
#include "categories/render.hpp"
#include "tracer/scene_crossings.hpp"

namespace raycat::app {
namespace {

using Json = nlohmann::ordered_json;

struct ProbeOptions {
  CommonOptions common;
  ViewOptions view;
  std::string pixel;
  std::string rays;
};

// --- A pixel: its ray tree and category.

struct Pixel {
  int x = 0;
  int y = 0;
};

Pixel parse_pixel(const std::string& text, const ImageSize& size) {
  Pixel pixel;
  const char* const end = text.data() + text.size();
  const auto [comma, x_error] = std::from_chars(text.data(), end, pixel.x);
  if (x_error != std::errc() || comma == end || *comma != ',') {
    throw UsageError(fmt::format("--pixel {}: expected X,Y, such as 256,256", text));
  }
  const auto [last, y_error] = std::from_chars(comma + 1, end, pixel.y);
  if (y_error != std::errc() || last != end) {
    throw UsageError(fmt::format("--pixel {}: expected X,Y, such as 256,256", text));
  }
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.width || pixel.y >= size.height) {
    throw UsageError(
        fmt::format("--pixel {}: the image has {}x{} pixels", text, size.width, size.height));
  }
  return pixel;
}

std::string surface_name(const SurfaceTable& surfaces, SurfaceId surface) {
  const std::string& object = surfaces.name(surfaces.object(surface));
  const std::string& primitive = surfaces.name(surfaces.primitive(surface));
  return fmt::format("{} face {}",
                     object == primitive ? object : fmt::format("{} / {}", object, primitive),
                     surfaces.face_in_primitive(surface));
}

std::vector<std::string> light_names(const Scene& scene, LightMask lights) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    if ((lights >> i & 1) != 0) {
      names.push_back(scene.lights[i].name);
    }
  }
  return names;
}

std::string hexadecimal(const CategoryWords& words) {
  std::string text;
  for (const std::uint32_t word : words) {
    text += fmt::format("{}{:08x}", text.empty() ? "" : " ", word);
  }
  return text;
}

// The tree root first, each node under the one that led to it.
std::string drawn(const Scene& scene, RayTree tree) {
  if (tree.empty()) {
    return "the ray leaves the scene";
  }
  // In the order of a walk from the root, refraction first: by the path of bits from the top.
  const auto path = [](const RayNode& node) {
    return node.position << (most_levels - level(node.position));
  };
  std::ranges::sort(tree, [&](const RayNode& a, const RayNode& b) {
    return path(a) != path(b) ? path(a) < path(b) : a.position < b.position;
  });
  std::string text;
  for (const RayNode& node : tree) {
    const char* const way = node.position == root      ? "camera"
                            : (node.position & 1) == 0 ? "refraction"
                                                       : "reflection";
    text += fmt::format("{}{:{}}{} {}: {}", text.empty() ? "" : "\n", "",
                        2 * (level(node.position) - 1), node.position, way,
                        surface_name(scene.surfaces, node.surface));
    std::string lights;
    for (const std::string& name : light_names(scene, node.lights)) {
      lights += (lights.empty() ? "" : ", ") + name;
    }
    text +=
        fmt::format(", lit by {}, weight {:.4g}", lights.empty() ? "nothing" : lights, node.weight);
  }
  return text;
}

void probe_pixel(const ProbeOptions& options, SceneFile& file) {
  const ImageSize size = parse_size(options.view.size);
  const Pixel pixel = parse_pixel(options.pixel, size);
  const Camera camera = choose_camera(file, options.view, size);
  add_default_lights(file.scene, camera);
  const Scene& scene = file.scene;
  const Accel accel(scene);
  TraceScratch scratch;
  RayTree tree;
  const glm::vec3 colour =
      trace(accel, ImagePlane(camera, size.width, size.height).ray(pixel.x + 0.5, pixel.y + 0.5),
            options.view.levels, tree, scratch);
  const Encoder encoder = heap_encoder(extent(scene, {}, options.view.levels));
  CategoryWords words;
  encode(encoder, tree, words);
  if (!options.common.json) {
    print(drawn(scene, tree));
    print(fmt::format("heap category: {}", words.empty() ? "empty" : hexadecimal(words)));
    print(fmt::format("linear colour: {:.4g} {:.4g} {:.4g}", colour.r, colour.g, colour.b));
    return;
  }
  Json nodes = Json::array();
  for (const RayNode& node : tree) {
    nodes.push_back({{"position", node.position},
                     {"object", scene.surfaces.name(scene.surfaces.object(node.surface))},
                     {"primitive", scene.surfaces.name(scene.surfaces.primitive(node.surface))},
                     {"face", scene.surfaces.face_in_primitive(node.surface)},
                     {"id", static_cast<std::uint32_t>(node.surface)},
                     {"lights", light_names(scene, node.lights)},
                     {"weight", node.weight}});
  }
  print(dump(Json{{"pixel", {pixel.x, pixel.y}},
                  {"nodes", nodes},
                  {"categories", {{"heap", words}}},
                  {"colour", {colour.r, colour.g, colour.b}}}));
}

// --- Rays: all crossings along each.

std::optional<Ray> parse_ray(const std::string& line) {
  double numbers[6];
  const char* at = line.data();
  const char* const end = at + line.size();
  const auto skip_space = [&] {
    while (at != end && (*at == ' ' || *at == '\t' || *at == '\r')) {
      ++at;
    }
  };
  for (double& number : numbers) {
    skip_space();
    at += at != end && *at == '+' ? 1 : 0;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc() || !std::isfinite(number)) {
      return std::nullopt;
    }
    at = next;
  }
  skip_space();
  const Ray ray{.origin = {numbers[0], numbers[1], numbers[2]},
                .direction = {numbers[3], numbers[4], numbers[5]}};
  const bool usable =
      at == end && glm::length(ray.direction) > 0.0 && std::isfinite(glm::length(ray.direction));
  return usable ? std::optional(ray) : std::nullopt;
}

Json to_json(const SurfaceTable& surfaces, const SceneCrossing& crossing) {
  const glm::dvec3 normal = crossing.normal + 0.0;  // no -0
  return {{"t", crossing.t},
          {"object", surfaces.name(surfaces.object(crossing.surface))},
          {"primitive", surfaces.name(surfaces.primitive(crossing.surface))},
          {"face", surfaces.face_in_primitive(crossing.surface)},
          {"id", static_cast<std::uint32_t>(crossing.surface)},
          {"entering", crossing.entering},
          {"normal", {normal.x, normal.y, normal.z}}};
}

void probe_rays(const ProbeOptions& options, const SceneFile& file, std::istream& in) {
  const SceneCrossings scene(file.scene);
  Solid::Scratch scratch;
  std::vector<SceneCrossing> crossings;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) {
      continue;
    }
    const std::optional<Ray> ray = parse_ray(line);
    if (!ray) {
      throw UsageError(fmt::format(
          "{}: line {}: expected six numbers, ox oy oz dx dy dz, with a direction that is not zero",
          options.rays, number));
    }
    scene.cross(*ray, scratch, crossings);
    std::erase_if(crossings, [](const SceneCrossing& crossing) { return crossing.t < 0.0; });
    if (options.common.json) {
      Json list = Json::array();
      for (const SceneCrossing& crossing : crossings) {
        list.push_back(to_json(file.scene.surfaces, crossing));
      }
      print(dump(Json{{"crossings", list}}));
      continue;
    }
    print(fmt::format("ray {}: {} crossings", number, crossings.size()));
    for (const SceneCrossing& crossing : crossings) {
      print(fmt::format("  t {:<12.9g} {} {}, normal {:.6g} {:.6g} {:.6g}", crossing.t,
                        crossing.entering ? "into" : "out of",
                        surface_name(file.scene.surfaces, crossing.surface), crossing.normal.x,
                        crossing.normal.y, crossing.normal.z));
    }
  }
}

void probe(const ProbeOptions& options) {
  if (options.pixel.empty() == options.rays.empty()) {
    throw UsageError("probe: give either --pixel X,Y or --rays FILE");
  }
  SceneFile file = load(options.common);
  if (!options.common.quiet) {
    warn(file.warnings);
  }
  if (!options.pixel.empty()) {
    probe_pixel(options, file);
  } else if (options.rays == "-") {
    probe_rays(options, file, std::cin);
  } else {
    std::ifstream in(options.rays);
    if (!in || std::filesystem::is_directory(options.rays)) {
      throw UsageError(fmt::format("{}: cannot be read: expected a file of rays", options.rays));
    }
    probe_rays(options, file, in);
  }
}

}  // namespace

void add_probe(CLI::App& app) {
  auto options = std::make_shared<ProbeOptions>();
  CLI::App* command =
      app.add_subcommand("probe", "Show the ray tree of a pixel, or what given rays cross");
  add_common(*command, options->common);
  add_view(*command, options->view);
  command->add_option("--pixel", options->pixel, "Show the ray tree and category of this pixel")
      ->type_name("X,Y");
  command
      ->add_option("--rays", options->rays,
                   "List the crossings of each ray of a file, or of stdin with -: lines ox oy oz "
                   "dx dy dz; t counts from 0 on in units of the direction")
      ->type_name("FILE");
  command->callback([options] { probe(*options); });
}

}  // namespace raycat::app
