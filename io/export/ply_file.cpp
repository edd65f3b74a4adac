#include "io/export/ply_file.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "io/files/byte_buffer.hpp"
#include "io/files/output_file.hpp"

namespace raycat {
namespace {

std::string one_line(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return name;
}

// The names of the objects, and of the primitives that have something left of them.
std::string names(const SurfaceTable& surfaces, std::span<const ObjectMesh> objects,
                  std::span<const TriangleMesh> meshes) {
  std::string out;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    std::vector<std::uint32_t> faces = meshes[i].faces;
    std::ranges::sort(faces);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    if (faces.empty()) {
      continue;
    }
    fmt::format_to(std::back_inserter(out), "comment object {} {}\n",
                   static_cast<std::size_t>(objects[i].object),
                   one_line(surfaces.name(objects[i].object)));
    std::optional<PrimitiveId> last;
    for (const std::uint32_t face : faces) {
      const PrimitiveId primitive =
          surfaces.primitive(SurfaceId{static_cast<std::uint32_t>(objects[i].first_face) + face});
      if (primitive != last) {
        fmt::format_to(std::back_inserter(out), "comment primitive {} {}\n",
                       static_cast<std::size_t>(primitive), one_line(surfaces.name(primitive)));
        last = primitive;
      }
    }
  }
  return out;
}

}  // namespace

void write_ply(const std::filesystem::path& path, const SurfaceTable& surfaces,
               std::span<const ObjectMesh> objects) {
  std::vector<TriangleMesh> meshes;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  for (const ObjectMesh& object : objects) {
    meshes.push_back(welded_mesh(object));
    vertices += meshes.back().positions.size();
    triangles += meshes.back().triangles.size();
  }
  if (vertices > std::numeric_limits<std::int32_t>::max()) {
    throw std::length_error("a PLY file holds at most 2147483647 vertices");
  }
  ByteBuffer out;
  out.put(std::string_view("ply\nformat binary_little_endian 1.0\ncomment written by raycat\n"));
  out.put(std::string_view(names(surfaces, objects, meshes)));
  out.put(std::string_view(
      fmt::format("element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
                  "element face {}\nproperty list uchar int vertex_indices\n"
                  "property uint object\nproperty uint primitive\nproperty uint face\nend_header\n",
                  vertices, triangles)));
  for (const TriangleMesh& mesh : meshes) {
    for (const glm::dvec3& p : mesh.positions) {
      out.put(p.x);
      out.put(p.y);
      out.put(p.z);
    }
  }
  std::uint32_t first = 0;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const TriangleMesh& mesh = meshes[i];
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
      const SurfaceId face{static_cast<std::uint32_t>(objects[i].first_face) + mesh.faces[k]};
      out.put(std::uint8_t{3});
      for (int corner = 0; corner < 3; ++corner) {
        out.put(static_cast<std::int32_t>(first + mesh.triangles[k][corner]));
      }
      out.put(static_cast<std::uint32_t>(objects[i].object));
      out.put(static_cast<std::uint32_t>(surfaces.primitive(face)));
      out.put(surfaces.face_in_primitive(face));
    }
    first += static_cast<std::uint32_t>(mesh.positions.size());
  }
  write_file(path, out.bytes());
}

}  // namespace raycat
