#include "app/view.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtx/component_wise.hpp>
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

struct StandardView {
  const char* option;
  const char* orbit;
  const char* help;
};

// The elevation of an isometric view is asin(1 / sqrt 3).
constexpr std::array<StandardView, 4> standard_views{
    {{"--top", "0,90", "Look from above, the front at the bottom: --orbit 0,90"},
     {"--front", "0,0", "Look from the front: --orbit 0,0"},
     {"--right", "90,0", "Look from the right: --orbit 90,0"},
     {"--iso", "45,35.264389682754654",
      "Look from the front right and above, all axes alike: --orbit 45,35.264"}}};

// Numbers with commas between them, from `least` to `most` of them.
std::vector<double> parse_numbers(std::string_view option, const std::string& text,
                                  std::size_t least, std::size_t most, std::string_view form) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const auto number = parse<double>(part);
    if (!number || !std::isfinite(*number)) {
      const bool blanks = part.find(' ') != std::string::npos;
      throw UsageError(fmt::format("{} {}: '{}' is not a number{}", option, text, part,
                                   blanks ? ": numbers need commas between them" : ""));
    }
    numbers.push_back(*number);
    begin = end + 1;
  }
  if (numbers.size() < least || numbers.size() > most) {
    throw UsageError(fmt::format("{} {}: expected {}", option, text, form));
  }
  return numbers;
}

glm::dvec3 up_of(const SceneFile& file, const ViewOptions& options) {
  if (options.up.empty()) {
    return file.up;
  }
  const std::vector<double> numbers = parse_numbers("--up", options.up, 3, 3, "x,y,z");
  const glm::dvec3 up(numbers[0], numbers[1], numbers[2]);
  const double greatest = glm::compMax(glm::abs(up));
  if (!(greatest > 0.0)) {
    throw UsageError(fmt::format("--up {}: has no direction", options.up));
  }
  return glm::normalize(up / greatest);
}

// Eye and target, and maybe the vertical field of view in degrees.
Camera view_camera(const ViewOptions& options, const glm::dvec3& up) {
  const std::string& text = options.view;
  const std::vector<double> numbers =
      parse_numbers("--view", text, 6, 7, "ex,ey,ez,tx,ty,tz or ex,ey,ez,tx,ty,tz,fov_degrees");
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
    return options.orthographic ? orthographic(camera, glm::distance(eye, target)) : camera;
  } catch (const UsageError&) {
    throw;
  } catch (const std::invalid_argument& error) {
    throw UsageError(fmt::format("--view {}: {}", text, error.what()));
  }
}

// Around the middle of the scene: all of it is seen, or it is at the distance that is asked for.
Camera orbit_camera(const SceneFile& file, const ViewOptions& options, const glm::dvec3& up,
                    double aspect) {
  const std::vector<double> numbers = parse_numbers(
      "--orbit", options.orbit, 2, 3, "AZIMUTH,ELEVATION or AZIMUTH,ELEVATION,DISTANCE");
  if (std::abs(numbers[1]) > 90.0) {
    throw UsageError(
        fmt::format("--orbit {}: the elevation is between -90 and 90 degrees", options.orbit));
  }
  const Orbit from = orbit(up, glm::radians(numbers[0]), glm::radians(numbers[1]));
  const Bounds box = bounds(file.scene);
  if (numbers.size() == 2) {
    return frame(box, from.towards_eye, from.up, aspect, options.orthographic);
  }
  const double distance = numbers[2];
  const glm::dvec3 middle = box.empty() || !box.finite() ? glm::dvec3(0.0) : box.center();
  if (!(distance > 0.0)) {
    throw UsageError(fmt::format("--orbit {}: the distance must be more than 0", options.orbit));
  }
  Camera camera = look_at(from.towards_eye, glm::dvec3(0.0), from.up);
  camera.eye = middle + distance * from.towards_eye;
  return options.orthographic ? orthographic(camera, distance) : camera;
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
  std::vector<CLI::Option*> views;
  const auto add_one_of = [&](CLI::Option* view) {
    for (CLI::Option* other : views) {
      view->excludes(other);
    }
    views.push_back(view);
    return view;
  };
  CLI::Option* camera = add_one_of(
      command.add_option("--camera", options.camera, "Camera of the scene, by name or from 0")
          ->type_name("NAME|INDEX"));
  add_one_of(command
                 .add_option("--view", options.view,
                             "Look from e to t; the vertical field of view is 40 degrees if left "
                             "out")
                 ->type_name("ex,ey,ez,tx,ty,tz[,fov_degrees]"));
  add_one_of(command
                 .add_option("--orbit", options.orbit,
                             "Look at the middle of the scene from so many degrees round it, 0 "
                             "from the front and 90 from the right, and above it; all of it is in "
                             "view, or it is at a distance")
                 ->type_name("AZIMUTH,ELEVATION[,DISTANCE]"));
  for (const StandardView& view : standard_views) {
    add_one_of(command.add_flag_callback(
        view.option, [&options, &view] { options.orbit = view.orbit; }, view.help));
  }
  command
      .add_option("--up", options.up,
                  "What is upright in a view that is no camera of the scene's; +Y or +Z by the "
                  "kind of file")
      ->type_name("x,y,z")
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
  const double aspect = static_cast<double>(size.width) / size.height;
  const glm::dvec3 up = up_of(file, options);
  if (!options.view.empty()) {
    return view_camera(options, up);
  }
  if (!options.orbit.empty()) {
    return orbit_camera(file, options, up, aspect);
  }
  if (options.camera.empty()) {
    if (!options.up.empty()) {
      throw UsageError("--up goes with --view, --orbit or a view such as --front");
    }
    return default_camera(file, aspect, options.orthographic);
  }
  const Camera& camera = named_camera(file, options.camera);
  return options.orthographic ? orthographic(camera, distance_to_middle(file.scene, camera))
                              : camera;
}

}  // namespace raycat::app
