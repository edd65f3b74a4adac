#include "io/meshes/mesh_file.hpp"

#include <cmath>
#include <cstdint>
#include <exception>
#include <ios>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <OpenMesh/Core/IO/reader/OBJReader.hh>
#include <OpenMesh/Core/IO/reader/OFFReader.hh>
#include <OpenMesh/Core/IO/reader/PLYReader.hh>
#include <OpenMesh/Core/IO/reader/STLReader.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <fmt/format.h>

#include "geometry/mesh_faces.hpp"
#include "io/files/input_file.hpp"
#include "io/files/load_error.hpp"
#include "io/meshes/mesh_text.hpp"
#include "io/meshes/plain_ply.hpp"

namespace raycat {

namespace {

constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 32;

// Takes vertices and faces from OpenMesh's readers. Unlike OpenMesh's own, it keeps faces that
// are not manifold.
class Collector : public OpenMesh::IO::BaseImporter {
 public:
  using Face = OpenMesh::FaceHandle;
  using Edge = OpenMesh::EdgeHandle;
  using Halfedge = OpenMesh::HalfedgeHandle;
  using Vertex = OpenMesh::VertexHandle;

  // Every vertex and corner takes at least a byte, so that more than `most` are not in the file.
  explicit Collector(std::size_t most) : most_(most) {}

  std::vector<glm::dvec3> points;
  std::vector<std::vector<std::uint32_t>> polygons;

  Vertex add_vertex(const OpenMesh::Vec3f& point) override { return add_point(point); }
  Vertex add_vertex(const OpenMesh::Vec3d& point) override { return add_point(point); }
  Vertex add_vertex() override { return add_point(OpenMesh::Vec3f(0.0f)); }
  void set_point(Vertex vertex, const OpenMesh::Vec3f& point) override {
    points.at(static_cast<std::size_t>(vertex.idx())) = {point[0], point[1], point[2]};
  }
  Face add_face(const VHandles& corners) override {
    corners_ += corners.size();
    require(corners_);
    std::vector<std::uint32_t> polygon;
    polygon.reserve(corners.size());
    for (const Vertex corner : corners) {
      polygon.push_back(static_cast<std::uint32_t>(corner.idx()));
    }
    polygons.push_back(std::move(polygon));
    return Face(static_cast<int>(polygons.size() - 1));
  }
  std::size_t n_vertices() const override { return points.size(); }
  std::size_t n_faces() const override { return polygons.size(); }
  std::size_t n_edges() const override { return 0; }

  // What else a file may hold is not of interest.
  Halfedge add_edge(Vertex, Vertex) override { return Halfedge(); }
  Face add_face(Halfedge) override { return Face(); }
  void add_face_texcoords(Face, Vertex, const std::vector<OpenMesh::Vec2f>&) override {}
  void add_face_texcoords(Face, Vertex, const std::vector<OpenMesh::Vec3f>&) override {}
  void set_face_texindex(Face, int) override {}
  void set_halfedge(Vertex, Halfedge) override {}
  void set_normal(Vertex, const OpenMesh::Vec3f&) override {}
  void set_normal(Vertex, const OpenMesh::Vec3d&) override {}
  void set_color(Vertex, const OpenMesh::Vec3uc&) override {}
  void set_color(Vertex, const OpenMesh::Vec4uc&) override {}
  void set_color(Vertex, const OpenMesh::Vec3f&) override {}
  void set_color(Vertex, const OpenMesh::Vec4f&) override {}
  void set_texcoord(Vertex, const OpenMesh::Vec2f&) override {}
  void set_status(Vertex, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_next(Halfedge, Halfedge) override {}
  void set_face(Halfedge, Face) override {}
  void request_face_texcoords2D() override {}
  void set_texcoord(Halfedge, const OpenMesh::Vec2f&) override {}
  void set_texcoord(Vertex, const OpenMesh::Vec3f&) override {}
  void set_texcoord(Halfedge, const OpenMesh::Vec3f&) override {}
  void set_status(Halfedge, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_color(Edge, const OpenMesh::Vec3uc&) override {}
  void set_color(Edge, const OpenMesh::Vec4uc&) override {}
  void set_color(Edge, const OpenMesh::Vec3f&) override {}
  void set_color(Edge, const OpenMesh::Vec4f&) override {}
  void set_status(Edge, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_normal(Face, const OpenMesh::Vec3f&) override {}
  void set_normal(Face, const OpenMesh::Vec3d&) override {}
  void set_color(Face, const OpenMesh::Vec3uc&) override {}
  void set_color(Face, const OpenMesh::Vec4uc&) override {}
  void set_color(Face, const OpenMesh::Vec3f&) override {}
  void set_color(Face, const OpenMesh::Vec4f&) override {}
  void set_status(Face, const OpenMesh::Attributes::StatusInfo&) override {}
  void add_texture_information(int, std::string) override {}

 private:
  template <typename Point>
  Vertex add_point(const Point& point) {
    require(points.size() + 1);
    points.emplace_back(point[0], point[1], point[2]);
    return Vertex(static_cast<int>(points.size() - 1));
  }
  void require(std::size_t count) const {
    if (count > most_) {
      throw std::length_error("more vertices or corners than the file can hold");
    }
  }

  std::size_t most_;
  std::size_t corners_ = 0;
};

// A stream that throws where data is missing or malformed, as the readers do not look.
std::istringstream strict(std::string bytes) {
  std::istringstream in(std::move(bytes));
  in.exceptions(std::ios::failbit | std::ios::badbit);
  return in;
}

bool read_ply(std::string_view bytes, Collector& out) {
  PlainPly plain = plain_ply(bytes);
  // The reader looks at the format of the file before. This is that file.
  std::istringstream before = strict(fmt::format(
      "ply\nformat {} 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 0\nproperty list uchar int vertex_indices\nend_header\n\n",
      plain.binary ? "binary_little_endian" : "ascii"));
  OpenMesh::IO::Options options;
  OpenMesh::IO::PLYReader().read(before, out, options);
  options.clear();
  std::istringstream in = strict(std::move(plain.bytes));
  return OpenMesh::IO::PLYReader().read(in, out, options);
}

bool read_with_openmesh(const std::filesystem::path& file, SceneKind kind, const std::string& bytes,
                        Collector& out) {
  OpenMesh::IO::Options options;
  if (kind == SceneKind::ply) {
    return read_ply(bytes, out);
  }
  if (kind == SceneKind::stl) {
    const bool binary = is_binary_stl(bytes);
    std::istringstream in(bytes);
    if (binary) {
      options += OpenMesh::IO::Options::Binary;
      in.exceptions(std::ios::failbit | std::ios::badbit);
    }
    return OpenMesh::IO::STLReader().read(in, out, options);
  }
  if (kind == SceneKind::off) {
    std::istringstream in = strict(plain_off(bytes));
    // Reads the first line, to learn which columns the vertices have.
    return OpenMesh::IO::OFFReader().can_u_read(file.string()) &&
           OpenMesh::IO::OFFReader().read(in, out, options);
  }
  std::istringstream in(plain_obj(bytes));
  return OpenMesh::IO::OBJReader().read(in, out, options);
}

}  // namespace

TriangleMesh read_mesh_file(const std::filesystem::path& file, SceneKind kind) {
  const std::string bytes = read_input_file(file, most_bytes);
  omerr().disable();
  omlog().disable();
  Collector collected(bytes.size());
  try {
    if (!read_with_openmesh(file, kind, bytes, collected)) {
      throw LoadError(file, "", "is not a mesh file of its kind");
    }
    for (std::size_t i = 0; i < collected.points.size(); ++i) {
      const glm::dvec3& point = collected.points[i];
      if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) {
        throw LoadError(file, fmt::format("vertex {}", i), "is not finite");
      }
    }
    TriangleMesh mesh = triangulate(std::move(collected.points), collected.polygons);
    if (mesh.triangles.empty()) {
      throw LoadError(file, "", "holds no triangle");
    }
    mesh.faces.clear();
    mesh.face_count = 0;
    return mesh;
  } catch (const LoadError&) {
    throw;
  } catch (const std::ios_base::failure&) {
    throw LoadError(file, "", "is truncated or malformed");
  } catch (const std::exception& error) {
    throw LoadError(file, "", error.what());
  }
}

}  // namespace raycat
