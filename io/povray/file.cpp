#include "io/povray/file.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "io/files/output_file.hpp"
#include "io/povray/material.hpp"
#include "io/povray/shape.hpp"
#include "io/povray/text.hpp"
#include "io/povray/tree.hpp"

namespace raycat {
namespace {

const glm::vec3 black(0.0f);

// The radius of the ball around all that is bounded, the camera's eye and the lights; not 0.
double reach(Bounds all, const Scene& scene, const Camera& camera) {
  all.include(camera.eye);
  for (const Light& light : scene.lights) {
    if (light.kind != Light::Kind::directional) {
      all.include(light.position);
    }
  }
  const double radius = glm::length(all.half_size());
  return radius > 0.0 ? radius : 1.0;
}

// POV-Ray's tolerances are absolute: it sees nothing past 1e7 and nothing smaller than about
// 1e-4. Scenes of a usual size keep their numbers.
double scale_for(double reach) { return reach > 0.1 && reach < 1e4 ? 1.0 : 100.0 / reach; }

class Writer {
 public:
  Writer(const Scene& scene, const PovPicture& picture)
      : scene_(scene),
        picture_(picture),
        bounds_(bounds(scene)),
        reach_(reach(bounds_, scene, picture.camera)),
        scale_(scale_for(reach_)),
        shapes_(scale_),
        specular_ratio_(specular_to_diffuse(scene.lights)) {}

  std::string text() {
    head();
    camera();
    for (const Light& light : scene_.lights) {
      add(light);
    }
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
      out_ += pov_comment(scene_.materials[i].name) +
              fmt::format("#declare Material{} =\n{}\n", i,
                          pov_texture(scene_.materials[i], specular_ratio_));
    }
    for (const SolidObject& object : scene_.solids) {
      add(object);
    }
    for (const MeshInstance& instance : scene_.meshes) {
      add(instance);
    }
    return std::move(out_);
  }

 private:
  void head() {
    out_ += fmt::format(
        "// Render with: povray +IFILE.pov +W{} +H{} -A -J File_Gamma=sRGB\n"
        "// Coordinates are right-handed, which the camera's vectors make POV-Ray.\n",
        picture_.width, picture_.height);
    if (scale_ != 1.0) {
      out_ += fmt::format("// Everything is {} times as large as in the scene.\n", scale_);
    }
    out_ += fmt::format(
        "#version 3.7;\n"
        "global_settings {{ assumed_gamma 1.0 ambient_light {} max_trace_level {} adc_bailout 0 "
        "}}\n"
        "background {{ {} }}\n",
        pov_colour(scene_.ambient_light), picture_.levels, pov_colour(scene_.background));
  }

  void camera() {
    const Camera& camera = picture_.camera;
    const double height = 2.0 * camera.half_height * (camera.orthographic ? scale_ : 1.0);
    const double width = height * picture_.width / picture_.height;
    out_ += fmt::format("camera {{\n  {}\n  location {}\n  direction {}\n  right {}\n  up {}\n}}\n",
                        camera.orthographic ? "orthographic" : "perspective",
                        pov_vector(scale_ * camera.eye), pov_vector(camera.forward),
                        pov_vector(width * camera.right), pov_vector(height * camera.up));
  }

  void add(const Light& light) {
    glm::vec3 colour = light.diffuse;
    std::string more;
    glm::dvec3 from = light.position;
    if (light.kind == Light::Kind::directional) {
      const glm::dvec3 to = bounds_.empty() ? picture_.camera.eye : bounds_.center();
      from = to - 1e3 * reach_ * light.direction;
      more += fmt::format(" parallel point_at {}", pov_vector(scale_ * to));
    }
    if (light.kind == Light::Kind::spot) {
      more += fmt::format(" spotlight radius {} falloff {} tightness 0 point_at {}",
                          glm::degrees(light.inner_cone), glm::degrees(light.outer_cone),
                          pov_vector(scale_ * (from + reach_ * light.direction)));
    }
    if (light.inverse_square && light.kind != Light::Kind::directional) {
      // It falls off as 2 / (1 + (distance / near)^2), which from afar is 2 (near / distance)^2.
      const double near = 1e-3 * scale_ * reach_;
      colour *= static_cast<float>(scale_ * scale_ / (2.0 * near * near));
      more += fmt::format(" fade_distance {} fade_power 2", near);
    }
    out_ +=
        pov_comment(light.name) + fmt::format("light_source {{ {}, {}{} }}\n",
                                              pov_vector(scale_ * from), pov_colour(colour), more);
  }

  void add(const SolidObject& object) {
    const auto material = [&](std::size_t leaf) -> const Material& {
      return scene_.materials[static_cast<std::size_t>(object.materials[leaf])];
    };
    std::string interior;
    bool transparent = false;
    for (std::size_t i = 0; i < object.materials.size(); ++i) {
      transparent = transparent || material(i).transmission != black || material(i).blend;
      interior = interior.empty() ? pov_interior(material(i)) : interior;
    }
    const std::string tree =
        pov_tree(object.solid.tree(), transparent, [&](const CsgLeaf& leaf, std::size_t i) {
          return shapes_.open(leaf.shape) +
                 fmt::format(" texture {{ Material{} }}",
                             static_cast<std::size_t>(object.materials[i]));
        });
    finish(object.solid.tree().leaves().front().first_face, tree + interior);
  }

  void add(const MeshInstance& instance) {
    const auto index = static_cast<std::size_t>(instance.material);
    finish(instance.first_face, shapes_.open(instance) +
                                    fmt::format(" texture {{ Material{} }}", index) +
                                    pov_interior(scene_.materials[index]));
  }

  void finish(SurfaceId face, const std::string& object) {
    out_ += shapes_.take_declarations() +
            pov_comment(scene_.surfaces.name(scene_.surfaces.object(face))) + object + " }\n";
  }

  const Scene& scene_;
  const PovPicture& picture_;
  Bounds bounds_;
  double reach_;
  double scale_;
  PovShapes shapes_;
  float specular_ratio_;
  std::string out_;
};

std::vector<std::string> left_out(const Scene& scene) {
  std::vector<std::string> lines;
  const auto add_if = [&](bool is_left_out, const char* what) {
    if (is_left_out) {
      lines.push_back(fmt::format("the file for POV-Ray leaves out {}", what));
    }
  };
  add_if(std::ranges::any_of(scene.materials,
                             [](const Material& m) { return m.base_texture || m.varying; }),
         "image textures");
  add_if(std::ranges::any_of(scene.materials,
                             [](const Material& m) { return m.absorption != glm::vec3(0.0f); }),
         "what volumes absorb");
  add_if(
      std::ranges::any_of(scene.materials, [](const Material& m) { return m.alpha_cutoff > 0.0f; }),
      "alpha masks");
  add_if(std::ranges::any_of(scene.meshes,
                             [](const MeshInstance& m) { return !m.mesh->colours.empty(); }),
         "vertex colours");
  add_if(std::ranges::any_of(scene.lights, [](const Light& l) { return std::isfinite(l.range); }),
         "the range of lights");
  return lines;
}

}  // namespace

std::vector<std::string> write_pov(const std::filesystem::path& path, const Scene& scene,
                                   const PovPicture& picture) {
  write_file(path, Writer(scene, picture).text());
  return left_out(scene);
}

}  // namespace raycat
