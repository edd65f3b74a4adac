#include "io/povray/file.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "io/files/input_file.hpp"
#include "io/images/decode.hpp"
#include "io/load_scene.hpp"
#include "support/scenes.hpp"
#include "support/temporary_folder.hpp"
#include "tracer/srgb.hpp"
#include "tracer/tracer.hpp"

namespace raycat {
namespace {

constexpr int side = 256;

using Bytes8 = std::vector<std::uint8_t>;  // RGBA of a square image

bool povray_present() { return std::system("command -v povray > /dev/null 2>&1") == 0; }

Bytes8 povray(const Scene& scene, const Camera& camera) {
  const TemporaryFolder folder;
  write_pov(folder / "scene.pov", scene, {.camera = camera, .width = side, .height = side});
  const std::string command = fmt::format(
      "cd '{}' && povray +Iscene.pov +Oscene.png +W{} +H{} -A -J -D +WT2 File_Gamma=sRGB "
      "> log 2>&1",
      folder.path().string(), side, side);
  if (std::system(command.c_str()) != 0) {
    FAIL("povray fails on " << read_bytes(folder / "log", 1 << 20).data());
  }
  const auto png = read_bytes(folder / "scene.png", 1 << 24);
  DecodedImage image = decode_image(png, side * side);
  REQUIRE(image.rgba.size() == std::size_t{4} * side * side);
  return std::move(image.rgba);
}

Bytes8 raycat(const Scene& scene, const Camera& camera) {
  const Accel accel(scene);
  const ImagePlane plane(camera, side, side);
  TraceScratch scratch;
  NoRecord nothing;
  Bytes8 out;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const glm::vec3 colour = trace(accel, plane.sample_ray(x, y), 8, nothing, scratch);
      for (int k = 0; k < 3; ++k) {
        const float value = srgb_from_linear(std::clamp(colour[k], 0.0f, 1.0f));
        out.push_back(static_cast<std::uint8_t>(255.0f * value + 0.5f));
      }
      out.push_back(255);
    }
  }
  return out;
}

// How many pixels differ by more than `most` in a channel.
int different(const Bytes8& a, const Bytes8& b, int most) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); i += 4) {
    int off = 0;
    for (std::size_t k = i; k < i + 3; ++k) {
      off = std::max(off, std::abs(int{a[k]} - int{b[k]}));
    }
    count += off > most ? 1 : 0;
  }
  return count;
}

// A colour that 8 bits hold, another for each number below 511.
glm::vec3 code(std::size_t number) {
  glm::vec3 colour;
  for (int k = 0; k < 3; ++k, number /= 8) {
    colour[k] = linear_from_srgb(static_cast<float>(45 + 30 * (number % 8)) / 255.0f);
  }
  return colour;
}

// Each primitive in one colour of its own, before black.
Scene silhouettes(Scene scene) {
  scene.background = glm::vec3(0.0f);
  scene.lights.clear();
  scene.materials.clear();
  const auto next = [&] {
    scene.materials.push_back({.emission = code(scene.materials.size())});
    return MaterialId{static_cast<std::uint32_t>(scene.materials.size() - 1)};
  };
  for (SolidObject& object : scene.solids) {
    std::ranges::generate(object.materials, next);
  }
  for (MeshInstance& instance : scene.meshes) {
    instance.material = next();
  }
  REQUIRE(scene.materials.size() < 511);
  return scene;
}

void compare(const std::string& name, const Scene& scene, const Camera& camera) {
  const Scene flat = silhouettes(scene);
  const int outlines = different(raycat(flat, camera), povray(flat, camera), 3);
  const int colours = different(raycat(scene, camera), povray(scene, camera), 12);
  WARN(fmt::format("{}: of {} pixels, {} are of another primitive, {} of another colour", name,
                   side * side, outlines, colours));
  CHECK(outlines <= side * side / 1000);
  CHECK(colours <= side * side / 1000);
}

TEST_CASE("POV-Ray renders the scenes of assets as we do", "[io][pov]") {
  if (!povray_present()) {
    WARN("skipped: no povray");
    return;
  }
  const auto* const name = GENERATE("fig8", "fig9", "fig10", "csg_part", "mesh_csg", "composite");
  const SceneFile file = load_scene(fmt::format("{}/scenes/{}.gltf", RAYCAT_ASSETS, name));
  compare(name, file.scene, file.scene.cameras.front());
}

// Every shape, also within set operations and much larger or smaller than POV-Ray likes.
Scene shapes(double unit) {
  SceneBuilder builder;
  const MaterialId red = builder.material({.ambient = glm::vec3(0.2f), .diffuse{0.7f, 0.3f, 0.2f}});
  const MaterialId green = builder.material(
      {.ambient{0.1f, 0.2f, 0.1f}, .diffuse{0.1f, 0.5f, 0.2f}, .specular = glm::vec3(0.3f)});
  const MaterialId glass = builder.material(
      {.reflection = glm::vec3(0.1f), .transmission = glm::vec3(0.8f), .ior = 1.3f});
  const glm::dmat4 world = glm::scale(glm::dmat4(1.0), glm::dvec3(unit));
  const auto turned = [&](double x, double y, double z) {
    return world * at(x, y, z) * glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1.0, 0.4, 0.3));
  };
  builder.shape("spindle", Torus{.radius = 0.5, .tube = 0.8}, turned(-2.5, 1.2, 0), red);
  builder.shape("horn", Torus{.radius = 0.5, .tube = 0.5}, turned(0, 1.2, -0.5), green);
  builder.shape("ring", Torus{.radius = 0.5, .tube = 0.2}, turned(2.6, 1.6, -0.5), red);
  builder.shape("capsule", Capsule{.height = 1.2, .radius_top = 0.2, .radius_bottom = 0.5},
                turned(1.8, 0.8, 1.2), green);
  builder.shape("apex", Capsule{.height = 0.8, .radius_top = 0.0, .radius_bottom = 0.3},
                turned(-1.8, 0.6, 1.8), red);
  builder.shape("ball in ball", Capsule{.height = 0.1, .radius_top = 0.1, .radius_bottom = 0.3},
                turned(0.7, 0.4, 2.1), red);
  builder.shape("cone", Cylinder{.height = 0.8, .radius_top = 0.1, .radius_bottom = 0.4},
                turned(-0.8, 0.6, 2.2), green);
  builder.shape("mirrored ellipsoid", Sphere{0.5},
                turned(-2.8, 0.5, 1.2) * glm::scale(glm::dmat4(1.0), glm::dvec3(1.4, -0.5, 0.8)),
                green);
  builder.pair("cut spindle", Operation::difference, Torus{.radius = 0.3, .tube = 0.5},
               turned(0.2, 0.8, 1.2), Box{glm::dvec3(2.0)}, turned(0.2, 0.8, 2.2), red);
  builder.pair("glass", Operation::set_union, Sphere{0.5}, turned(3.0, 0.6, 1.6), Sphere{0.4},
               turned(3.4, 0.7, 1.4), glass);
  builder.shape("floor", HalfSpace{}, world, red);
  builder.light({.kind = Light::Kind::directional,
                 .direction = glm::normalize(glm::dvec3(-0.3, -1.0, -0.5)),
                 .diffuse = glm::vec3(0.4f),
                 .specular = glm::vec3(0.4f)});
  const auto strength = static_cast<float>(20.0 * unit * unit);
  builder.light({.position = unit * glm::dvec3(3.0, 6.0, 5.0),
                 .diffuse = glm::vec3(strength),
                 .specular = glm::vec3(strength),
                 .inverse_square = true});
  return builder.take();
}

TEST_CASE("POV-Ray renders every shape at every size as we do", "[io][pov]") {
  if (!povray_present()) {
    WARN("skipped: no povray");
    return;
  }
  const double unit = GENERATE(1.0, 1e-6, 1e7);
  Camera camera = look_at(unit * glm::dvec3(1.0, 5.0, 11.0), unit * glm::dvec3(0.0, 0.8, 0.5),
                          glm::dvec3(0.0, 1.0, 0.0));
  camera.orthographic = unit != 1.0;
  camera.half_height = camera.orthographic ? 3.0 * unit : 0.3;
  compare(fmt::format("shapes of {}", unit), shapes(unit), camera);
}

TEST_CASE("what POV-Ray has no words for is said to be left out", "[io][pov]") {
  SceneBuilder builder;
  const MaterialId plain = builder.material({});
  const MaterialId masked = builder.material({.alpha_cutoff = 0.5f});
  SurfaceMesh coloured = square(1.0);
  coloured.colours.assign(4, glm::vec4(1.0f));
  builder.mesh("a", coloured, at(0, 0, 0), plain).mesh("b", square(1.0), at(0, 0, 1), masked);
  builder.light({.range = 10.0});
  const TemporaryFolder folder;
  CHECK(write_pov(folder / "a.pov", builder.take(), {}) ==
        std::vector<std::string>{"the file for POV-Ray leaves out alpha masks",
                                 "the file for POV-Ray leaves out vertex colours",
                                 "the file for POV-Ray leaves out the range of lights"});
}

TEST_CASE("a mesh that is placed twice is declared once, and names cannot end a comment",
          "[io][pov]") {
  SceneBuilder builder;
  const MaterialId plain = builder.material({.name = "a\nb"});
  builder.mesh("one", square(1.0), at(0, 0, 0), plain);
  Scene scene = builder.take();
  scene.meshes.push_back(scene.meshes.front());
  scene.meshes.back().transform = Affine(at(0, 0, 2));
  const TemporaryFolder folder;
  CHECK(write_pov(folder / "a.pov", scene, {}).empty());
  const auto bytes = read_bytes(folder / "a.pov", 1 << 16);
  const std::string text(bytes.begin(), bytes.end());
  CHECK(text.find("#declare Mesh1") != std::string::npos);
  CHECK(text.find("#declare Mesh2") == std::string::npos);
  CHECK(text.find("\n// a?b\n") != std::string::npos);
  CHECK(text.find("object { Mesh1 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 2> texture") !=
        std::string::npos);
}

}  // namespace
}  // namespace raycat
