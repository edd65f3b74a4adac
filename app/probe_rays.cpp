#include <charconv>
#include <cmath>
#include <istream>
#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "app/probe.hpp"
#include "app/report.hpp"
#include "tracer/scene_crossings.hpp"

namespace raycat::app {
namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace

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

}  // namespace raycat::app
