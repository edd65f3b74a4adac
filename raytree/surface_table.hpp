#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "raytree/surface_id.hpp"

namespace raycat {

enum class ObjectId : std::uint32_t {};
enum class PrimitiveId : std::uint32_t {};

/// How finely surfaces are told apart (Section 3.1).
enum class Granularity { object, primitive, face };

/// Names every surface of a scene. An object (a top-level CSG tree, lone shape or mesh node) has
/// primitives (CSG leaves, glTF primitives), and a primitive has faces, which are what rays hit.
/// All are numbered from 0 in the order they are added, so the faces of a primitive are
/// contiguous, and so are those of an object.
class SurfaceTable {
 public:
  ObjectId add_object(std::string name);

  /// Adds a primitive of `faces` faces to the newest object and returns its first face. Throws
  /// `std::length_error` past 2^32 - 1 faces.
  SurfaceId add_primitive(std::string name, std::uint32_t faces);

  std::size_t objects() const noexcept { return objects_.size(); }
  std::size_t primitives() const noexcept { return primitives_.size(); }
  std::size_t faces() const noexcept { return primitive_of_.size(); }
  std::size_t count(Granularity granularity) const noexcept;

  PrimitiveId primitive(SurfaceId face) const { return primitive_of_[index(face)]; }
  ObjectId object(SurfaceId face) const { return object(primitive(face)); }
  ObjectId object(PrimitiveId id) const { return primitives_[static_cast<std::size_t>(id)].object; }

  /// The surface that holds `face`, numbered from 0 within `granularity`.
  SurfaceId at(Granularity granularity, SurfaceId face) const;

  /// Which face of its primitive this is, from 0.
  std::uint32_t face_in_primitive(SurfaceId face) const;

  const std::string& name(ObjectId id) const { return objects_[static_cast<std::size_t>(id)]; }
  const std::string& name(PrimitiveId id) const {
    return primitives_[static_cast<std::size_t>(id)].name;
  }

 private:
  struct Primitive {
    std::string name;
    ObjectId object{};
    SurfaceId first{};
  };

  static std::size_t index(SurfaceId face) noexcept { return static_cast<std::size_t>(face); }

  std::vector<std::string> objects_;
  std::vector<Primitive> primitives_;
  std::vector<PrimitiveId> primitive_of_;
};

}  // namespace raycat
