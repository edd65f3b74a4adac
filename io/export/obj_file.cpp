#include "io/export/obj_file.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "io/export/surface_label.hpp"
#include "io/files/output_file.hpp"

namespace raycat {

void write_obj(const std::filesystem::path& path, const SurfaceTable& surfaces,
               std::span<const ObjectMesh> objects) {
  std::string out = "# written by raycat\n";
  std::size_t vertices = 1;  // which OBJ counts from, through all objects
  for (const ObjectMesh& object : objects) {
    const TriangleMesh mesh = welded_mesh(object);
    if (mesh.triangles.empty()) {
      continue;
    }
    fmt::format_to(std::back_inserter(out), "o {}\n", one_word(surfaces.name(object.object)));
    for (const glm::dvec3& p : mesh.positions) {
      fmt::format_to(std::back_inserter(out), "v {} {} {}\n", p.x, p.y, p.z);
    }
    std::vector<std::size_t> by_face(mesh.triangles.size());
    std::iota(by_face.begin(), by_face.end(), std::size_t{0});
    std::ranges::stable_sort(by_face, {}, [&](std::size_t i) { return mesh.faces[i]; });
    for (std::size_t i = 0; i < by_face.size(); ++i) {
      const std::uint32_t face = mesh.faces[by_face[i]];
      if (i == 0 || face != mesh.faces[by_face[i - 1]]) {
        const SurfaceId surface{static_cast<std::uint32_t>(object.first_face) + face};
        fmt::format_to(std::back_inserter(out), "g {}\n", surface_label(surfaces, surface));
      }
      const glm::uvec3& t = mesh.triangles[by_face[i]];
      fmt::format_to(std::back_inserter(out), "f {} {} {}\n", vertices + t.x, vertices + t.y,
                     vertices + t.z);
    }
    vertices += mesh.positions.size();
  }
  write_file(path, out);
}

}  // namespace raycat
