#include "io/gltf/primitive.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "geometry/coincident_twins.hpp"
#include "geometry/mesh_faces.hpp"
#include "io/files/load_error.hpp"
#include "io/gltf/accessor.hpp"
#include "io/gltf/borders.hpp"
#include "threads/parallel.hpp"

namespace raycat {
namespace {

// What the tables of a scene can count.
constexpr std::size_t max_vertices = std::numeric_limits<std::uint32_t>::max();

template <class Vector>
bool finite(const Vector& vector) {
  for (int c = 0; c < vector.length(); ++c) {
    if (!std::isfinite(vector[c])) {
      return false;
    }
  }
  return true;
}

class PrimitiveReader {
 public:
  PrimitiveReader(GltfDocument& document, std::size_t mesh, std::size_t primitive, int threads)
      : document_(document),
        mesh_(mesh),
        primitive_(primitive),
        threads_(threads),
        from_(document.model.meshes[mesh].primitives[primitive]),
        place_(fmt::format("meshes[{}]", mesh)),
        path_(fmt::format("primitives[{}]", primitive)) {}

  std::optional<GltfPrimitive> read(const GltfMaterial* material, const FeatureNames* names,
                                    GltfTextures& textures, LoadBudget& budget) {
    const auto positions = attribute("POSITION", 3, 3);
    if (!positions) {
      warn("has no positions and is not drawn");
      return std::nullopt;
    }
    CoordinateSets sets = material ? material->coordinates : CoordinateSets();
    const auto mapped = feature_map(document_, mesh_, primitive_, textures, sets);
    auto mesh = std::make_shared<SurfaceMesh>();
    std::vector<std::uint32_t> vertices;
    std::optional<std::vector<std::uint32_t>> polygons;
    {
      const SpentTime reading(budget.spent().meshes);
      mesh->triangles.triangles = read_triangles(positions->size(), budget);
      vertices = renumber(mesh->triangles.triangles, positions->size());
      mesh->triangles.positions.resize(vertices.size());
      parallel_each(vertices.size(), threads_, [&](std::size_t i) {
        mesh->triangles.positions[i] = glm::dvec3((*positions)[vertices[i]]);
      });
      polygons = authored_polygons(document_, mesh_, primitive_, mesh->triangles.triangles);
      drop_infinite(mesh->triangles, polygons);
      read_normals(vertices, positions->size(), *mesh);
      read_coordinates(sets, vertices, positions->size(), *mesh);
      read_colours(vertices, positions->size(), *mesh);
    }
    const SpentTime grouping(budget.spent().faces);
    bool has_faces = true;
    if (const auto features =
            feature_ids(document_, mesh_, primitive_, vertices, positions->size())) {
      take_features(*features, names, mesh->triangles);
      find_twins(*mesh);
    } else if (mapped && has_coordinates(*mesh, mapped->map->place)) {
      take_features(*mapped, *mesh);
      find_twins(*mesh);
    } else if (names != nullptr) {
      fail("extras.raycat: names features, but none can be read");
    } else if (polygons) {
      find_twins(*mesh);
      mesh->triangles.faces = with_copies_joined(*std::move(polygons), mesh->twins);
      count_faces(mesh->triangles);
    } else if (auto outline = authored_outline(document_, mesh_, primitive_, positions->size())) {
      group_between(*std::move(outline), vertices, *mesh);
    } else {
      has_faces = false;
    }
    const bool deformable = !from_.targets.empty() || from_.attributes.contains("JOINTS_0");
    GltfPrimitive out{.number = primitive_, .triangles = mesh->triangles.triangles.size()};
    out.mesh = std::move(mesh);
    out.has_faces = has_faces;
    if (from_.material >= 0) {
      out.material = static_cast<std::size_t>(from_.material);
    }
    if (deformable) {
      out.vertices = std::move(vertices);
    }
    return out;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw LoadError(document_.file, place_, path_ + ": " + what);
  }

  void warn(const std::string& what) const {
    document_.warnings.push_back(fmt::format("{}: {}: {}", place_, path_, what));
  }

  // How many of the numbers below `size` are such that `test(i)`.
  template <class Test>
  std::size_t count_numbers(std::size_t size, const Test& test) const {
    std::atomic<std::size_t> count = 0;
    parallel_parts(size, threads_, [&](std::size_t begin, std::size_t end, int) {
      std::size_t of_part = 0;
      for (std::size_t i = begin; i < end; ++i) {
        of_part += test(i) ? std::size_t{1} : std::size_t{0};
      }
      count += of_part;
    });
    return count;
  }

  std::optional<GltfAccessor> attribute(const std::string& name, int least, int most) const {
    const auto found = from_.attributes.find(name);
    if (found == from_.attributes.end()) {
      return std::nullopt;
    }
    GltfAccessor accessor(document_, static_cast<std::size_t>(found->second));
    if (accessor.components() < least || accessor.components() > most) {
      fail(fmt::format("{}: accessors[{}] has {} components", name, found->second,
                       accessor.components()));
    }
    return accessor;
  }

  // An attribute that does not reach all vertices could only be read past its end.
  std::optional<GltfAccessor> vertex_attribute(const std::string& name, int least, int most,
                                               std::size_t vertices) const {
    auto accessor = attribute(name, least, most);
    if (accessor && accessor->size() < vertices) {
      warn(fmt::format("{} has {} elements for {} vertices and is ignored", name, accessor->size(),
                       vertices));
      return std::nullopt;
    }
    return accessor;
  }

  // The order of corners is that of glTF 2.0 (3.7.2.1).
  std::vector<glm::uvec3> read_triangles(std::size_t vertices, LoadBudget& budget) const {
    if (vertices > max_vertices) {
      fail(fmt::format("at most {} vertices are read, but there are {}", max_vertices, vertices));
    }
    std::optional<GltfAccessor> indices;
    if (from_.indices >= 0) {
      const auto number = static_cast<std::size_t>(from_.indices);
      const auto& accessor = document_.model.accessors[number];
      if (accessor.type != TINYGLTF_TYPE_SCALAR || !is_index_type(accessor.componentType)) {
        fail(fmt::format("indices: accessors[{}] does not hold indices", number));
      }
      indices.emplace(document_, number);
    }
    const std::size_t count = indices ? indices->size() : vertices;
    // A file can name the same accessors any number of times, at no cost to itself.
    constexpr std::uint64_t bytes_a_corner = 64;
    budget.take_memory(document_.file, place_ + ": " + path_, count, bytes_a_corner);
    const auto corner = [&](std::size_t i) {
      return indices ? indices->index(i) : static_cast<std::uint32_t>(i);
    };
    const auto out_of_range = [&](std::size_t i) { return corner(i) >= vertices; };
    if (indices && count_numbers(count, out_of_range) > 0) {
      std::size_t i = 0;
      while (!out_of_range(i)) {
        ++i;
      }
      fail(fmt::format("indices: index {} at {} is past the {} vertices", corner(i), i, vertices));
    }
    std::vector<glm::uvec3> triangles;
    if (from_.mode == TINYGLTF_MODE_TRIANGLES) {
      triangles.resize(count / 3);
      parallel_each(triangles.size(), threads_, [&](std::size_t i) {
        triangles[i] = {corner(3 * i), corner(3 * i + 1), corner(3 * i + 2)};
      });
      if (count % 3 != 0) {
        warn(fmt::format("{} corners are no whole number of triangles; the last are ignored",
                         count));
      }
      return triangles;
    }
    for (std::size_t i = 0; i + 2 < count; ++i) {
      const std::size_t odd = from_.mode == TINYGLTF_MODE_TRIANGLE_STRIP ? i % 2 : 0;
      if (from_.mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
        triangles.push_back({corner(i), corner(i + 1 + odd), corner(i + 2 - odd)});
      } else {
        triangles.push_back({corner(i + 1), corner(i + 2), corner(0)});
      }
    }
    return triangles;
  }

  // Primitives often share one long list of vertices; each keeps those it uses, in their order.
  static std::vector<std::uint32_t> renumber(std::vector<glm::uvec3>& triangles,
                                             std::size_t vertices) {
    std::vector<std::uint32_t> used;
    const auto for_each_corner = [&](const auto& visit) {
      for (glm::uvec3& triangle : triangles) {
        visit(triangle.x);
        visit(triangle.y);
        visit(triangle.z);
      }
    };
    // Where few of many vertices are used, a table of all of them would be the longer way.
    if (vertices > 24 * triangles.size()) {
      for_each_corner([&](std::uint32_t corner) { used.push_back(corner); });
      std::ranges::sort(used);
      used.erase(std::unique(used.begin(), used.end()), used.end());
      for_each_corner([&](std::uint32_t& corner) {
        corner = static_cast<std::uint32_t>(std::ranges::lower_bound(used, corner) - used.begin());
      });
      return used;
    }
    constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(vertices, unused);
    for_each_corner([&](std::uint32_t corner) { number[corner] = 0; });
    used.reserve(vertices);
    for (std::uint32_t vertex = 0; vertex < vertices; ++vertex) {
      if (number[vertex] != unused) {
        number[vertex] = static_cast<std::uint32_t>(used.size());
        used.push_back(vertex);
      }
    }
    if (used.size() < vertices) {
      for_each_corner([&](std::uint32_t& corner) { corner = number[corner]; });
    }
    return used;
  }

  void drop_infinite(TriangleMesh& mesh,
                     std::optional<std::vector<std::uint32_t>>& polygons) const {
    const auto infinite = [&](std::size_t i) { return !finite(mesh.positions[i]); };
    if (count_numbers(mesh.positions.size(), infinite) == 0) {
      return;
    }
    const auto whole = [&](const glm::uvec3& t) {
      return finite(mesh.positions[t.x]) && finite(mesh.positions[t.y]) &&
             finite(mesh.positions[t.z]);
    };
    std::size_t kept = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (whole(mesh.triangles[i])) {
        mesh.triangles[kept] = mesh.triangles[i];
        if (polygons) {
          (*polygons)[kept] = (*polygons)[i];
        }
        ++kept;
      }
    }
    const std::size_t dropped = mesh.triangles.size() - kept;
    mesh.triangles.resize(kept);
    if (polygons) {
      polygons->resize(kept);
    }
    for (glm::dvec3& position : mesh.positions) {
      position = finite(position) ? position : glm::dvec3(0.0);
    }
    if (dropped > 0) {
      warn(fmt::format("{} triangles with a corner that is not finite are dropped", dropped));
    }
  }

  void read_normals(const std::vector<std::uint32_t>& vertices, std::size_t count,
                    SurfaceMesh& mesh) const {
    const auto normals = vertex_attribute("NORMAL", 3, 3, count);
    if (!normals) {
      return;
    }
    mesh.normals.resize(vertices.size());
    parallel_each(vertices.size(), threads_, [&](std::size_t i) {
      const glm::dvec3 normal((*normals)[vertices[i]]);
      const double length = glm::length(normal);
      const bool usable = std::isfinite(length) && length > 0.0;
      mesh.normals[i] = usable ? glm::vec3(normal / length) : glm::vec3(0.0f);
    });
    const std::size_t unusable = count_numbers(
        mesh.normals.size(), [&](std::size_t i) { return mesh.normals[i] == glm::vec3(0.0f); });
    if (unusable > 0) {
      warn(fmt::format("{} normals have no direction and are made anew", unusable));
      replace_zero_normals(mesh);
    }
  }

  // The mean of the planes around, by area.
  static void replace_zero_normals(SurfaceMesh& mesh) {
    std::vector<glm::dvec3> sums(mesh.normals.size(), glm::dvec3(0.0));
    const auto& positions = mesh.triangles.positions;
    for (const glm::uvec3& corners : mesh.triangles.triangles) {
      const glm::dvec3 plane = glm::cross(positions[corners.y] - positions[corners.x],
                                          positions[corners.z] - positions[corners.x]);
      sums[corners.x] += plane;
      sums[corners.y] += plane;
      sums[corners.z] += plane;
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
      if (mesh.normals[i] == glm::vec3(0.0f)) {
        const double length = glm::length(sums[i]);
        mesh.normals[i] = std::isfinite(length) && length > 0.0 ? glm::vec3(sums[i] / length)
                                                                : glm::vec3(0.0f, 1.0f, 0.0f);
      }
    }
  }

  void read_coordinates(const CoordinateSets& sets, const std::vector<std::uint32_t>& vertices,
                        std::size_t count, SurfaceMesh& mesh) const {
    for (const std::size_t set : sets) {
      auto& to = mesh.texture_coordinates.emplace_back();
      const auto coordinates = vertex_attribute(fmt::format("TEXCOORD_{}", set), 2, 2, count);
      to.reserve(coordinates ? vertices.size() : 0);
      for (std::size_t i = 0; coordinates && i < vertices.size(); ++i) {
        to.emplace_back((*coordinates)[vertices[i]]);
      }
    }
  }

  bool has_coordinates(const SurfaceMesh& mesh, const TexturePlace& place) const {
    const bool has = !mesh.texture_coordinates[place.coordinates].empty();
    if (!has) {
      warn("EXT_mesh_features: its texture coordinates are missing, and faces are found by angle");
    }
    return has;
  }

  void read_colours(const std::vector<std::uint32_t>& vertices, std::size_t count,
                    SurfaceMesh& mesh) const {
    const auto colours = vertex_attribute("COLOR_0", 3, 4, count);
    if (!colours) {
      return;
    }
    mesh.colours.reserve(vertices.size());
    for (const std::uint32_t vertex : vertices) {
      glm::dvec4 colour = (*colours)[vertex];
      colour.a = colours->components() == 3 ? 1.0 : colour.a;
      if (!finite(colour) || glm::any(glm::lessThan(colour, glm::dvec4(0.0)))) {
        warn("COLOR_0 holds a colour that is negative or not finite and is ignored");
        mesh.colours.clear();
        return;
      }
      mesh.colours.emplace_back(colour);
    }
  }

  // A triangle is of the feature of its first corner, as all of its corners should be.
  void take_features(const FeatureIds& features, const FeatureNames* names,
                     TriangleMesh& mesh) const {
    mesh.face_count = features.count;
    for (const glm::uvec3& corners : mesh.triangles) {
      mesh.faces.push_back(features.numbers[corners.x]);
    }
    if (names == nullptr) {
      return;
    }
    mesh.face_count = 0;
    for (std::uint32_t& face : mesh.faces) {
      if (face >= names->faces.size()) {
        fail(fmt::format("extras.raycat: features: feature {} is not among the {}", face,
                         names->faces.size()));
      }
      face = names->faces[face];
      mesh.face_count = std::max(mesh.face_count, face + 1);
    }
  }

  // What has to do with whole triangles knows them by their middles.
  static void take_features(const TexturedFeatures& features, SurfaceMesh& mesh) {
    mesh.features = features.map;
    mesh.triangles.face_count = features.count;
    mesh.triangles.faces.resize(mesh.triangles.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.faces.size(); ++i) {
      mesh.triangles.faces[i] = MeshPoint{.mesh = mesh,
                                          .triangle = static_cast<std::uint32_t>(i),
                                          .barycentric = glm::dvec2(1.0 / 3.0)}
                                    .face();
    }
  }

  // The outline is of the file's vertices, and lines between those that no triangle uses are none.
  void group_between(std::vector<glm::uvec2> outline, const std::vector<std::uint32_t>& vertices,
                     SurfaceMesh& mesh) const {
    std::erase_if(outline, [&](const glm::uvec2& line) {
      return !std::ranges::binary_search(vertices, line.x) ||
             !std::ranges::binary_search(vertices, line.y);
    });
    for (glm::uvec2& line : outline) {
      for (std::uint32_t* end : {&line.x, &line.y}) {
        *end =
            static_cast<std::uint32_t>(std::ranges::lower_bound(vertices, *end) - vertices.begin());
      }
    }
    const TriangleMesh& triangles = mesh.triangles;
    MeshFaces found =
        group_faces_between(triangles.positions, triangles.triangles, outline, threads_);
    mesh.triangles.faces = std::move(found.faces);
    mesh.twins = std::move(found.twins);
    count_faces(mesh.triangles);
  }

  void find_twins(SurfaceMesh& mesh) const {
    mesh.twins = coincident_twins(mesh.triangles.positions, mesh.triangles.triangles, threads_);
  }

  static void count_faces(TriangleMesh& mesh) {
    mesh.face_count = mesh.faces.empty() ? 0 : std::ranges::max(mesh.faces) + std::uint32_t{1};
  }

  GltfDocument& document_;
  std::size_t mesh_;
  std::size_t primitive_;
  int threads_;
  const tinygltf::Primitive& from_;
  std::string place_;
  std::string path_;
};

}  // namespace

std::optional<GltfPrimitive> read_primitive(GltfDocument& document, std::size_t mesh,
                                            std::size_t primitive, const GltfMaterial* material,
                                            const FeatureNames* names, GltfTextures& textures,
                                            LoadBudget& budget, int threads) {
  return PrimitiveReader(document, mesh, primitive, threads)
      .read(material, names, textures, budget);
}

}  // namespace raycat
