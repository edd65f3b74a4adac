#include <algorithm>
#include <charconv>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/probe.hpp"
#include "app/report.hpp"
#include "categories/exact_number.hpp"
#include "raycat/scene_view.hpp"

namespace raycat::app {
namespace {

using Json = nlohmann::ordered_json;

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

std::vector<std::string> light_names(const Scene& scene, LightMask lights) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    if ((lights >> i & 1) != 0) {
      names.push_back(scene.lights[i].name);
    }
  }
  return names;
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
      lights += (lights.empty() ? "" : ", ") + printable(name);
    }
    text +=
        fmt::format(", lit by {}, weight {:.4g}", lights.empty() ? "nothing" : lights, node.weight);
  }
  return text;
}

// Joins what `text` says of each of `items`.
template <typename Items, typename Text>
std::string listed(const Items& items, const char* between, const Text& text) {
  std::string all;
  for (const auto& item : items) {
    all += fmt::format("{}{}", all.empty() ? "" : between, text(item));
  }
  return all.empty() ? "empty" : all;
}

// Numbers with more bits are not worked out.
constexpr double most_bits = 1 << 16;

// A pixel's category under every method (Section 2.1).
struct Codes {
  CategoryWords heap;
  CategoryWords string;
  // Of the primes product, in the order of the string; none past that method's limits.
  std::optional<std::vector<std::uint32_t>> factors;
  double godel_bits = 0.0;  // about
};

Codes codes_of(const RayTree& tree, const Extent& extent) {
  Codes codes;
  encode(make_encoder(Method::heap, extent), tree, codes.heap);
  encode(make_encoder(Method::string, extent), tree, codes.string);
  if (within(extent, PrimesProduct::limits)) {
    PrimesProduct(extent).list_factors(tree, codes.factors.emplace());
  }
  codes.godel_bits = godel_bits(codes.string);
  return codes;
}

// A word of a string, by name: lights come first, then surfaces.
std::string symbol_name(const Scene& scene, const Extent& extent, Granularity ids,
                        std::uint32_t symbol) {
  const std::uint64_t index = symbol - 1;
  if (index < extent.lights) {
    return printable(scene.lights[index].name);
  }
  const std::uint64_t surface = index - extent.lights;
  const SurfaceTable& surfaces = scene.surfaces;
  if (surface == surfaces.count(ids)) {
    return "(untold)";
  }
  switch (ids) {
    case Granularity::object:
      return printable(surfaces.name(ObjectId{static_cast<std::uint32_t>(surface)}));
    case Granularity::primitive:
      return printable(surfaces.name(PrimitiveId{static_cast<std::uint32_t>(surface)}));
    case Granularity::face:
      break;
  }
  return surface_name(surfaces, SurfaceId{static_cast<std::uint32_t>(surface)});
}

void print_codes(const Codes& codes, const Scene& scene, const Extent& extent, Granularity ids) {
  print("string category: " + listed(codes.string, ", ", [&](std::uint32_t symbol) {
          return symbol_name(scene, extent, ids, symbol);
        }));
  if (codes.factors) {
    const BigInteger product = exact_product(*codes.factors);
    print(fmt::format("primes category: {}{}", product.str(),
                      (product >> 64) != 0 ? ", which overflows 64 bits" : ""));
  } else {
    print(fmt::format("primes category: none, since there are more than {} surfaces",
                      PrimesProduct::limits.surfaces));
  }
  if (codes.godel_bits > most_bits) {
    print(fmt::format("godel category: a number of about {:.0f} bits", codes.godel_bits));
  } else {
    print("godel category: " + godel_number(codes.string).str());
  }
  print("heap category: " +
        listed(codes.heap, " ", [](std::uint32_t word) { return fmt::format("{:08x}", word); }));
}

Json to_json(const Codes& codes) {
  Json primes = nullptr;
  if (codes.factors) {
    primes = exact_product(*codes.factors).str();
  }
  Json godel = nullptr;
  if (codes.godel_bits <= most_bits) {
    godel = godel_number(codes.string).str();
  }
  return {{"heap", codes.heap},
          {"string", codes.string},
          {"primes", primes},
          {"godel", godel},
          {"godel_bits", codes.godel_bits}};
}

}  // namespace

void probe_pixel(const ProbeOptions& options, SceneFile file) {
  const ImageSize size = parse_size(options.view.size);
  const Pixel pixel = parse_pixel(options.pixel, size);
  const Camera camera = camera_of(file, options.view, size);
  file.scene.counted_lights = counted_lights(options.detail);
  const SceneView view(std::move(file), camera);
  const Scene& scene = view.scene();
  const Detail detail = detail_for(options.detail, scene);
  TraceScratch scratch;
  RayTree tree;
  const glm::vec3 colour =
      trace(view.accel(), ImagePlane(camera, size.width, size.height).sample_ray(pixel.x, pixel.y),
            options.view.levels, tree, scratch);
  RayTree reduced(tree);
  reduce(reduced, detail, scene.surfaces);
  const Extent limits = extent(scene, detail, options.view.levels);
  const Codes codes = codes_of(reduced, limits);
  if (!options.common.json) {
    print(drawn(scene, tree));
    if (reduced.size() < tree.size()) {
      print(fmt::format("categories keep {} of these {} nodes", reduced.size(), tree.size()));
    }
    print_codes(codes, scene, limits, detail.ids);
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
                  {"categories", to_json(codes)},
                  {"colour", {colour.r, colour.g, colour.b}}}));
}

}  // namespace raycat::app
