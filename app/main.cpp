#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <new>
#include <numeric>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <malloc.h>

#include "app/command.hpp"
#include "app/help.hpp"
#include "app/interrupt.hpp"
#include "io/files/load_error.hpp"
#include "io/load_scene.hpp"

namespace raycat::app {

CLI::Validator number_in(double low, double high) {
  return CLI::Validator(
      [low, high](const std::string& text) {
        double value = 0.0;
        const bool in = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
        return in ? std::string()
                  : fmt::format("'{}' is not a number from {} to {}", text, low, high);
      },
      fmt::format("{} to {}", low, high));
}

namespace {

// Before a number is read, which would make much of less than 0.
CLI::Validator unsigned_number() {
  return CLI::Validator(
      [](const std::string& text) {
        const bool begins = !text.empty() && text[0] >= '0' && text[0] <= '9';
        return begins ? std::string() : fmt::format("'{}' is not a number of 0 or more", text);
      },
      "");
}

void add_limits(CLI::App& command, LoadLimits& limits) {
  start_group(command, groups::limits);
  command
      .add_option("--max-memory", limits.memory,
                  "What a glTF file may hold, as 512M or 2G; half of the machine's by default")
      ->type_name("SIZE")
      ->transform(CLI::AsSizeValue(false))
      ->transform(unsigned_number());
  const auto add_count = [&](const char* name, std::uint64_t& limit, const char* of) {
    command.add_option(name, limit, fmt::format("{} a glTF file may have; {}", of, limit))
        ->type_name("N")
        ->transform(unsigned_number());
  };
  add_count("--max-pixels", limits.pixels, "Pixels that each image of");
  add_count("--max-nodes", limits.nodes, "Nodes");
  add_count("--max-instances", limits.instances, "Instances");
  add_count("--max-triangles", limits.triangles, "Triangles, as drawn, that");
}

}  // namespace

void add_common(CLI::App& command, CommonOptions& options) {
  options.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  command
      .add_option("SCENE", options.scene, "Scene file: .gltf .glb .csg .scad .obj .ply .stl .off")
      ->required();
  start_group(command, groups::general);
  command.set_help_flag("-h,--help", "Print this help");
  command.add_option("--threads", options.threads, "Threads; all by default")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command.add_flag("--quiet", options.quiet, "No progress and no warnings on stderr");
  command.add_flag("--json", options.json, "Machine-readable result on stdout");
  start_group(command, groups::scene);
  command
      .add_option_function<double>(
          "--crease",
          [&options](double degrees) {
            options.load.faces.crease = degrees * 0.017453292519943295;
          },
          "Mesh triangles meeting at a smaller angle are one face; 30 by default")
      ->type_name("DEGREES")
      ->check(number_in(0.0, 180.0));
  add_choice<bool>(command, "--join-primitives", options.load.join_primitives,
                   {{"on", true}, {"off", false}},
                   "Primitives of a glTF mesh that continue each other, of one material, are one: "
                   "on (default) or off")
      ->type_name("on|off");
  command
      .add_option("--exposure", options.load.exposure,
                  "glTF's own lights count 2^EV times; 0 by default")
      ->type_name("EV")
      ->check(number_in(-64.0, 64.0));
  command.add_option("--scene", options.load.scene, "Scene of a glTF file, by name or from 0")
      ->type_name("NAME|N");
  command
      .add_option("--time", options.load.time,
                  "Pose glTF nodes as an animation has them at this time; at rest if left out")
      ->type_name("SECONDS")
      ->check(number_in(-1e9, 1e9));
  command
      .add_option("--animation", options.load.animation,
                  "Which animation --time is of, by name or from 0; the first by default")
      ->type_name("NAME|N")
      ->needs("--time");
  add_choice<Facetting>(command, "--facets", options.load.facets,
                        {{"openscad", Facetting::openscad}, {"smooth", Facetting::smooth}},
                        "Round things of .csg files: openscad (its facets; default) or smooth "
                        "(true spheres, cylinders and cones)")
      ->type_name("KIND");
  add_choice<BackFaces>(
      command, "--back-faces", options.load.back_faces,
      {{"hide", BackFaces::hide}, {"show", BackFaces::show}},
      "Back faces of meshes that glTF has single-sided and opaque: hide (default) "
      "or show")
      ->type_name("hide|show");
  command.add_flag("--keep-going", options.load.keep_going,
                   "Warn of .csg nodes that cannot be made, and read the rest");
  add_limits(command, options.load.limits);
}

SceneFile load(const CommonOptions& options) {
  LoadOptions load = options.load;
  load.threads = options.threads;
  return load_scene(options.scene, load);
}

namespace {

// One line, whatever names the message quotes.
int fail(int code, std::string message) {
  std::ranges::replace_if(
      message, [](unsigned char c) { return c < 0x20; }, ' ');
  fmt::print(stderr, "raycat: {}\n", message);
  return code;
}

// How many letters must be put in, taken out or changed to make the one of the other.
std::size_t edits(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t before = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = before + (a[i] == b[j] ? 0 : 1);
      before = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

// A question for the name that was meant; empty if none is like `name`.
std::string suggestion(const std::string& name, const std::vector<std::string>& known) {
  const auto far = [&](const std::string& other) { return edits(name, other); };
  const auto nearest = std::ranges::min_element(known, {}, far);
  const std::size_t most = std::max<std::size_t>(1, name.size() / 3);
  return nearest != known.end() && far(*nearest) <= most
             ? fmt::format(": did you mean {}?", *nearest)
             : std::string();
}

// The parser would only say that a subcommand is missing.
void require_known_subcommand(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') {
    return;
  }
  const std::string first = argv[1];
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  if (std::ranges::find(names, first) != names.end()) {
    return;
  }
  std::error_code ignored;
  if (std::filesystem::exists(first, ignored)) {
    throw UsageError(
        fmt::format("'{}' is a file: say before it what to do, as in raycat render "
                    "{}; one of {}",
                    first, first, fmt::join(names, ", ")));
  }
  throw UsageError(fmt::format("'{}' is not one of {}{}; see raycat --help", first,
                               fmt::join(names, ", "), suggestion(first, names)));
}

// Says which of the arguments that nothing was made of is an option, and what may have been meant.
std::string not_expected(const CLI::App& app) {
  std::vector<std::string> rest = app.remaining(true);
  const auto option =
      std::ranges::find_if(rest, [](const std::string& word) { return word.starts_with('-'); });
  if (option == rest.end()) {
    return fmt::format("'{}' is not expected", rest.empty() ? "" : rest.front());
  }
  const std::string name = option->substr(0, option->find('='));
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands()) {
    for (const CLI::Option* one : command->get_options()) {
      for (const std::string& long_name : one->get_lnames()) {
        known.push_back("--" + long_name);
      }
    }
  }
  return fmt::format("{} is no option here{}", name, suggestion(name, known));
}

int run(int argc, char** argv) {
  CLI::App app("Ray path categorization for CSG and glTF scenes", "raycat");
  app.formatter(std::make_shared<GroupedHelp>());
  start_group(app, groups::general);
  app.set_help_flag("-h,--help", "Print this help");
  app.set_version_flag("--version", "raycat " RAYCAT_VERSION);
  app.require_subcommand(1);
  add_render(app);
  add_info(app);
  add_probe(app);
  add_compare(app);
  add_study(app);
  add_measure(app);
  add_convert(app);
  require_known_subcommand(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return app.exit(CLI::CallForHelp());
  } catch (const CLI::CallForVersion& version) {
    return app.exit(version);
  } catch (const CLI::ExtrasError&) {
    return fail(2, fmt::format("{}; see raycat --help", not_expected(app)));
  } catch (const CLI::ParseError& error) {
    return fail(2, fmt::format("{}; see raycat --help", error.what()));
  }
  return 0;
}

}  // namespace
}  // namespace raycat::app

int main(int argc, char** argv) {
  using raycat::app::fail;
  // Large blocks go back to the system when they are freed: what reading a mesh took is not held
  // while its BVH is built.
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  raycat::app::handle_interrupts();
  try {
    return raycat::app::run(argc, argv);
  } catch (const raycat::LoadError& error) {
    return fail(2, error.what());
  } catch (const std::logic_error& error) {  // what the user asked for cannot be
    return fail(2, error.what());
  } catch (const std::bad_alloc&) {
    return fail(1, "out of memory");
  } catch (const std::exception& error) {
    return fail(1, error.what());
  }
}
