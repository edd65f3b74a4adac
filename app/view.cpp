#include "app/view.hpp"

#include <charconv>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/command.hpp"
#include "app/help.hpp"
#include "io/scene/default_view.hpp"
#include "raytree/ray_tree.hpp"

namespace raycat::app {
namespace {

template <typename Number>
std::optional<Number> parse(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    return std::nullopt;
  }
  return value;
}

struct View {
  Camera camera;
  double distance = 1.0;  // from eye to target
};

// Six numbers, eye and target, and maybe the vertical field of view in degrees.
View parse_view(const std::string& text, const glm::dvec3& up) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto number = parse<double>(std::string_view(text).substr(begin, end - begin));
    if (!number) {
      throw UsageError(
          fmt::format("--view {}: '{}' is not a number", text, text.substr(begin, end - begin)));
    }
    numbers.push_back(*number);
    begin = end + 1;
  }
  if (numbers.size() != 6 && numbers.size() != 7) {
    throw UsageError(fmt::format(
        "--view {}: expected ex,ey,ez,tx,ty,tz or ex,ey,ez,tx,ty,tz,fov_degrees", text));
  }
  try {
    const glm::dvec3 eye(numbers[0], numbers[1], numbers[2]);
    const glm::dvec3 target(numbers[3], numbers[4], numbers[5]);
    Camera camera = look_at(eye, target, up);
    if (numbers.size() == 7) {
      if (!(numbers[6] > 0.0 && numbers[6] < 180.0)) {
        throw UsageError(
            fmt::format("--view {}: the field of view is between 0 and 180 degrees", text));
      }
      camera.half_height = std::tan(glm::radians(numbers[6]) / 2.0);
    }
    return {.camera = camera, .distance = glm::distance(eye, target)};
  } catch (const UsageError&) {
    throw;
  } catch (const std::invalid_argument& error) {
    throw UsageError(fmt::format("--view {}: {}", text, error.what()));
  }
}

const Camera& named_camera(const SceneFile& file, const std::string& wanted) {
  const auto& cameras = file.scene.cameras;
  for (const Camera& camera : cameras) {
    if (camera.name == wanted) {
      return camera;
    }
  }
  if (const auto index = parse<std::size_t>(wanted); index && *index < cameras.size()) {
    return cameras[*index];
  }
  std::string names;
  for (const Camera& camera : cameras) {
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", camera.name);
  }
  throw UsageError(fmt::format("--camera {}: no such camera; the scene has {}", wanted,
                               names.empty() ? "none" : names));
}

}  // namespace

void add_view(CLI::App& command, ViewOptions& options) {
  start_group(command, groups::view);
  command.add_option("--size", options.size, "Image size in pixels")
      ->type_name("WxH")
      ->capture_default_str();
  auto* camera =
      command.add_option("--camera", options.camera, "Camera of the scene, by name or from 0")
          ->type_name("NAME|INDEX");
  command
      .add_option("--view", options.view,
                  "Look from e to t; the vertical field of view is 40 degrees if left out")
      ->type_name("ex,ey,ez,tx,ty,tz[,fov_degrees]")
      ->excludes(camera);
  command.add_flag("--ortho", options.orthographic, "Orthographic projection");
  command
      .add_option("--levels", options.levels,
                  "Levels of the ray tree, the camera ray's hit being the first")
      ->type_name("N")
      ->check(CLI::Range(1, most_levels))
      ->capture_default_str();
}

ImageSize parse_size(const std::string& text) {
  const std::size_t x = text.find('x');
  const auto width = parse<int>(std::string_view(text).substr(0, x));
  const auto height =
      x == std::string::npos ? std::nullopt : parse<int>(std::string_view(text).substr(x + 1));
  if (!width || !height) {
    throw UsageError(fmt::format("--size {}: expected WxH, such as 512x512", text));
  }
  if (*width < 1 || *height < 1 || *width > most_image_side || *height > most_image_side) {
    throw UsageError(fmt::format("--size {}: a side has 1 to {} pixels", text, most_image_side));
  }
  if (static_cast<long long>(*width) * *height > most_pixels) {
    throw UsageError(fmt::format("--size {}: an image has at most {} pixels", text, most_pixels));
  }
  return {.width = *width, .height = *height};
}

Camera camera_of(const SceneFile& file, const ViewOptions& options, const ImageSize& size) {
  if (!options.view.empty()) {
    const auto [camera, distance] = parse_view(options.view, file.up);
    return options.orthographic ? orthographic(camera, distance) : camera;
  }
  if (options.camera.empty()) {
    return default_camera(file, static_cast<double>(size.width) / size.height,
                          options.orthographic);
  }
  const Camera& camera = named_camera(file, options.camera);
  return options.orthographic ? orthographic(camera, distance_to_middle(file.scene, camera))
                              : camera;
}

}  // namespace raycat::app
