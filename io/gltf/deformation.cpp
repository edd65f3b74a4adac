#include "io/gltf/deformation.hpp"

#include <cmath>
#include <map>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "geometry/coincident_twins.hpp"
#include "io/files/load_error.hpp"
#include "io/gltf/accessor.hpp"

namespace raycat {
namespace {

/// Changes a copy of one primitive's mesh.
class Deformation {
 public:
  Deformation(const GltfDocument& document, std::size_t mesh, const GltfPrimitive& rest)
      : document_(document),
        from_(document.model.meshes[mesh].primitives[rest.number]),
        place_(fmt::format("meshes[{}]: primitives[{}]", mesh, rest.number)),
        vertices_(rest.vertices),
        mesh_(std::make_shared<SurfaceMesh>(*rest.mesh)) {}

  void morph(std::span<const double> weights) {
    for (std::size_t t = 0; t < from_.targets.size() && t < weights.size(); ++t) {
      if (weights[t] == 0.0) {
        continue;
      }
      if (const auto moved = attribute(from_.targets[t], "POSITION", 3)) {
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
          mesh_->triangles.positions[i] += weights[t] * glm::dvec3((*moved)[vertices_[i]]);
        }
      }
      const auto turned = attribute(from_.targets[t], "NORMAL", 3);
      for (std::size_t i = 0; turned && i < mesh_->normals.size(); ++i) {
        mesh_->normals[i] += glm::vec3(weights[t] * glm::dvec3((*turned)[vertices_[i]]));
      }
    }
  }

  void skin(std::span<const glm::dmat4> joints) {
    std::vector<glm::dmat4> moves(vertices_.size(), glm::dmat4(0.0));
    std::vector<double> sums(vertices_.size(), 0.0);
    for (int set = 0;; ++set) {
      const auto numbers = attribute(from_.attributes, fmt::format("JOINTS_{}", set), 4);
      const auto weights = attribute(from_.attributes, fmt::format("WEIGHTS_{}", set), 4);
      if (!numbers || !weights) {
        break;
      }
      for (std::size_t i = 0; i < vertices_.size(); ++i) {
        const glm::dvec4 number = (*numbers)[vertices_[i]];
        const glm::dvec4 weight = (*weights)[vertices_[i]];
        for (int c = 0; c < 4; ++c) {
          if (!(weight[c] > 0.0)) {
            continue;
          }
          if (!(number[c] >= 0.0 && number[c] < static_cast<double>(joints.size()))) {
            fail(fmt::format("JOINTS_{}: vertex {} is of joint {}, but the skin has {}", set,
                             vertices_[i], number[c], joints.size()));
          }
          moves[i] += weight[c] * joints[static_cast<std::size_t>(number[c])];
          sums[i] += weight[c];
        }
      }
    }
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      if (!(sums[i] > 0.0)) {
        continue;  // of no joint: it stays
      }
      const glm::dmat4 move = moves[i] / sums[i];
      glm::dvec3& position = mesh_->triangles.positions[i];
      position = glm::dvec3(move * glm::dvec4(position, 1.0));
      if (!mesh_->normals.empty()) {
        const glm::dvec3 columns[3] = {glm::dvec3(move[0]), glm::dvec3(move[1]),
                                       glm::dvec3(move[2])};
        // Cofactors, so that a matrix without an inverse does no harm.
        const glm::dmat3 turn(glm::cross(columns[1], columns[2]),
                              glm::cross(columns[2], columns[0]),
                              glm::cross(columns[0], columns[1]));
        mesh_->normals[i] = glm::vec3(turn * glm::dvec3(mesh_->normals[i]));
      }
    }
  }

  std::shared_ptr<SurfaceMesh> finish() {
    for (const glm::dvec3& position : mesh_->triangles.positions) {
      if (!(glm::dot(position, position) < 1e300)) {
        fail("its pose puts a vertex at no finite place");
      }
    }
    for (glm::vec3& normal : mesh_->normals) {
      const float length = glm::length(normal);
      normal =
          length > 0.0f && std::isfinite(length) ? normal / length : glm::vec3(0.0f, 1.0f, 0.0f);
    }
    if (!mesh_->twins.empty()) {  // which a pose may have moved apart
      mesh_->twins = coincident_twins(mesh_->triangles.positions, mesh_->triangles.triangles);
    }
    return mesh_;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw LoadError(document_.file, place_, what);
  }

  // Nothing if it is not there; what is there must reach all vertices.
  std::optional<GltfAccessor> attribute(const std::map<std::string, int>& attributes,
                                        const std::string& name, int components) const {
    const auto found = attributes.find(name);
    if (found == attributes.end()) {
      return std::nullopt;
    }
    GltfAccessor accessor(document_, static_cast<std::size_t>(found->second));
    if (accessor.components() != components ||
        (!vertices_.empty() && accessor.size() <= vertices_.back())) {
      fail(fmt::format("{}: accessors[{}] has {} elements of {} components", name, found->second,
                       accessor.size(), accessor.components()));
    }
    return accessor;
  }

  const GltfDocument& document_;
  const tinygltf::Primitive& from_;
  std::string place_;
  const std::vector<std::uint32_t>& vertices_;  // ascending
  std::shared_ptr<SurfaceMesh> mesh_;
};

}  // namespace

std::vector<glm::dmat4> joint_matrices(const GltfDocument& document, std::size_t skin,
                                       const GltfNodes& nodes) {
  const std::string place = fmt::format("skins[{}]", skin);
  JsonFields fields(document.file, place, "", document.json["skins"][skin]);
  std::vector<std::size_t> joints;
  for (const auto& joint : document.json["skins"][skin].value("joints", nlohmann::json::array())) {
    joints.push_back(joint);
  }
  const auto number =
      fields.index("inverseBindMatrices", "accessors", document.model.accessors.size());
  std::optional<GltfAccessor> inverse;
  if (number) {
    inverse.emplace(document, *number);
    if (!inverse->holds_matrices() || inverse->size() < joints.size()) {
      fields.fail(
          fmt::format("inverseBindMatrices: accessors[{}] has no matrix for each of {} joints",
                      *number, joints.size()));
    }
  }
  std::vector<glm::dmat4> matrices;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    matrices.push_back(nodes.world[joints[i]] * (inverse ? inverse->matrix(i) : glm::dmat4(1.0)));
  }
  return matrices;
}

std::shared_ptr<SurfaceMesh> deformed(const GltfDocument& document, std::size_t mesh,
                                      const GltfPrimitive& rest, std::span<const double> weights,
                                      std::span<const glm::dmat4> joints) {
  Deformation deformation(document, mesh, rest);
  deformation.morph(weights);
  if (!joints.empty()) {
    deformation.skin(joints);
  }
  return deformation.finish();
}

}  // namespace raycat
