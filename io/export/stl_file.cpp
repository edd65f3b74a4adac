#include "io/export/stl_file.hpp"

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include <glm/geometric.hpp>

#include "io/files/byte_buffer.hpp"
#include "io/files/output_file.hpp"

namespace raycat {

void write_stl(const std::filesystem::path& path, std::span<const ObjectMesh> objects) {
  std::vector<glm::vec3> corners;
  for (const ObjectMesh& object : objects) {
    for (const ObjectMesh::Part& part : object.parts) {
      const TriangleMesh& mesh = part.mesh.triangles;
      for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3 a(mesh.positions[t.x]);
        const glm::vec3 b(mesh.positions[t.y]);
        const glm::vec3 c(mesh.positions[t.z]);
        if (a != b && b != c && c != a) {  // else rounding has made nothing of it
          corners.insert(corners.end(), {a, b, c});
        }
      }
    }
  }
  if (corners.size() / 3 > std::numeric_limits<std::uint32_t>::max()) {
    throw std::length_error("an STL file holds at most 4294967295 triangles");
  }
  ByteBuffer out;
  std::string header = "raycat";  // readers take what begins with "solid" for text
  header.resize(80, ' ');
  out.put(std::string_view(header));
  out.put(static_cast<std::uint32_t>(corners.size() / 3));
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const glm::dvec3 across = glm::cross(glm::dvec3(corners[i + 1]) - glm::dvec3(corners[i]),
                                         glm::dvec3(corners[i + 2]) - glm::dvec3(corners[i]));
    const double length = glm::length(across);
    const glm::vec3 normal(length > 0.0 ? across / length : glm::dvec3(0.0));
    for (const glm::vec3& vector : {normal, corners[i], corners[i + 1], corners[i + 2]}) {
      out.put(vector.x);
      out.put(vector.y);
      out.put(vector.z);
    }
    out.put(std::uint16_t{0});
  }
  write_file(path, out.bytes());
}

}  // namespace raycat
