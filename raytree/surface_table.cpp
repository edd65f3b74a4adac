#include "raytree/surface_table.hpp"

#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace raycat {

ObjectId SurfaceTable::add_object(std::string name) {
  objects_.push_back(std::move(name));
  return ObjectId{static_cast<std::uint32_t>(objects_.size() - 1)};
}

SurfaceId SurfaceTable::add_primitive(std::string name, std::uint32_t faces) {
  const SurfaceId first{static_cast<std::uint32_t>(primitive_of_.size())};
  if (faces > std::numeric_limits<std::uint32_t>::max() - primitive_of_.size()) {
    throw std::length_error(fmt::format("a scene holds at most {} faces, but '{}' would make it {}",
                                        std::numeric_limits<std::uint32_t>::max(), name,
                                        primitive_of_.size() + faces));
  }
  const PrimitiveId id{static_cast<std::uint32_t>(primitives_.size())};
  primitives_.push_back({.name = std::move(name),
                         .object = ObjectId{static_cast<std::uint32_t>(objects_.size() - 1)},
                         .first = first});
  primitive_of_.resize(primitive_of_.size() + faces, id);
  return first;
}

std::size_t SurfaceTable::count(Granularity granularity) const noexcept {
  switch (granularity) {
    case Granularity::object:
      return objects();
    case Granularity::primitive:
      return primitives();
    case Granularity::face:
      break;
  }
  return faces();
}

SurfaceId SurfaceTable::at(Granularity granularity, SurfaceId face) const {
  switch (granularity) {
    case Granularity::object:
      return SurfaceId{static_cast<std::uint32_t>(object(face))};
    case Granularity::primitive:
      return SurfaceId{static_cast<std::uint32_t>(primitive(face))};
    case Granularity::face:
      break;
  }
  return face;
}

std::uint32_t SurfaceTable::face_in_primitive(SurfaceId face) const {
  const Primitive& of = primitives_[static_cast<std::size_t>(primitive(face))];
  return static_cast<std::uint32_t>(face) - static_cast<std::uint32_t>(of.first);
}

}  // namespace raycat
