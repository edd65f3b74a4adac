#include "geometry/coincident_surfaces.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>

#include <glm/geometric.hpp>

#include "geometry/surface_piece.hpp"

namespace raycat {
namespace {

constexpr std::uint32_t none = CoincidentSurfaces::none;

// What surfaces are looked up by: numbers of about 1 that differ little between surfaces that lie
// close together. The first three belong to a direction that has no sense.
struct Key {
  std::array<double, 6> values{};
  std::size_t count = 0;
  bool directed = true;

  void add(const glm::dvec3& v) {
    for (int k = 0; k < 3; ++k) {
      values[count++] = v[k];
    }
  }
};

Key key_of(const Plane& plane, double size) {
  Key key;
  key.add(plane.normal);
  key.values[key.count++] = plane.offset / size;
  return key;
}

Key key_of(const CurvedSurface& surface, double size) {
  Key key{.directed = surface.kind != CurvedSurface::Kind::ball};
  if (key.directed) {
    key.add(surface.axis);
  } else {
    key.values[key.count++] = surface.spread / size;
  }
  key.add(surface.middle / size);
  return key;
}

// The same surface seen from its other side.
Key reversed(Key key, const Plane& /*plane*/) {
  for (std::size_t k = 0; k < key.count; ++k) {
    key.values[k] = -key.values[k];
  }
  return key;
}

Key reversed(Key key, const CurvedSurface& /*surface*/) {
  for (std::size_t k = 0; k < 3; ++k) {
    key.values[k] = -key.values[k];
  }
  return key;
}

bool face_apart(const Plane& a, const Plane& b) { return glm::dot(a.normal, b.normal) < 0.0; }

bool face_apart(const CurvedSurface& /*a*/, const CurvedSurface& /*b*/) { return false; }

// Keys are looked up in cells, those that may differ by more in larger ones, so that few cells are
// looked at and few surfaces are in each.
constexpr std::array cells{0x1p-7, 0x1p-11, 0x1p-15, 0x1p-19};

std::size_t level_for(double noise) {
  std::size_t level = cells.size() - 1;
  while (level > 0 && noise > cells[level] / 8.0) {
    --level;
  }
  return level;
}

// By how much the keys of pieces may differ that lie in one surface. A piece so narrow that its
// direction says nothing is only looked for nearby.
double noise_of(const SurfacePiece& piece, double size, double tolerance) {
  const double noise = 4.0 * tolerance / std::min(piece.width, size);
  return std::min(noise, cells[0] / 2.0);
}

// The surfaces of one kind, by their keys.
template <typename Surface>
class Table {
 public:
  using Place = CoincidentSurfaces::Place;

  // Of as many surfaces as `most`, that are looked up on the levels whose bits are set.
  Table(double size, double tolerance, unsigned levels, std::size_t most)
      : size_(size),
        tolerance_(tolerance),
        levels_(levels),
        heads_(std::bit_ceil(std::max<std::size_t>(most, 1)), none) {}

  // The first surface that is near all samples of the piece; else the piece's own, numbered `next`.
  Place join(const Surface& surface, const SurfacePiece& piece, std::uint32_t next) {
    const double noise = noise_of(piece, size_, tolerance_);
    const std::size_t level = level_for(noise);
    const Key key = key_of(surface, size_);
    std::uint32_t found = none;
    find(key, level, noise, piece.samples, found);
    if (key.directed) {
      find(reversed(key, surface), level, noise, piece.samples, found);
    }
    if (found == none) {
      add(surface, key, next);
      return {.surface = next};
    }
    return {.surface = known_[found].number,
            .reversed = face_apart(known_[found].surface, surface)};
  }

 private:
  struct Entry {
    std::uint32_t known = 0;
    std::uint32_t next = none;
  };

  struct Known {
    Surface surface;
    std::uint32_t number = 0;
  };

  static std::int64_t index(double value, std::size_t level) {
    return static_cast<std::int64_t>(std::floor(value / cells[level]));
  }

  std::size_t slot(const std::array<std::int64_t, 6>& cell, std::size_t count,
                   std::size_t level) const {
    std::uint64_t hash = level;
    for (std::size_t k = 0; k < count; ++k) {
      hash = (hash ^ static_cast<std::uint64_t>(cell[k])) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 29U;
    }
    return hash & (heads_.size() - 1);
  }

  void add(const Surface& surface, const Key& key, std::uint32_t number) {
    std::array<std::int64_t, 6> cell{};
    for (std::size_t level = 0; level < cells.size(); ++level) {
      if ((levels_ >> level & 1U) == 0) {
        continue;
      }
      for (std::size_t k = 0; k < key.count; ++k) {
        cell[k] = index(key.values[k], level);
      }
      std::uint32_t& head = heads_[slot(cell, key.count, level)];
      entries_.push_back({.known = static_cast<std::uint32_t>(known_.size()), .next = head});
      head = static_cast<std::uint32_t>(entries_.size() - 1);
    }
    known_.push_back({.surface = surface, .number = number});
  }

  // Lowers `found` to the first of those in the cells around the key that is near all samples.
  void find(const Key& key, std::size_t level, double noise, std::span<const glm::dvec3> samples,
            std::uint32_t& found) const {
    std::array<std::int64_t, 6> low{};
    std::array<std::int64_t, 6> high{};
    for (std::size_t k = 0; k < key.count; ++k) {
      low[k] = index(key.values[k] - noise, level);
      high[k] = index(key.values[k] + noise, level);
    }
    std::array<std::int64_t, 6> cell = low;
    for (;;) {
      for (std::uint32_t entry = heads_[slot(cell, key.count, level)]; entry != none;
           entry = entries_[entry].next) {
        const std::uint32_t known = entries_[entry].known;
        if (known < found && holds(known_[known].surface, samples)) {
          found = known;
        }
      }
      std::size_t k = 0;
      while (k < key.count && ++cell[k] > high[k]) {
        cell[k] = low[k];
        ++k;
      }
      if (k == key.count) {
        return;
      }
    }
  }

  bool holds(const Surface& surface, std::span<const glm::dvec3> samples) const {
    return std::ranges::all_of(
        samples, [&](const glm::dvec3& sample) { return surface.distance(sample) <= tolerance_; });
  }

  double size_;
  double tolerance_;
  unsigned levels_;
  std::vector<Known> known_;
  std::vector<std::uint32_t> heads_;
  std::vector<Entry> entries_;
};

Bounds box_around(const SurfacePiece& piece) {
  Bounds box;
  for (const glm::dvec3& sample : piece.samples) {
    box.include(sample);
  }
  return box;
}

}  // namespace

double coincidence_tolerance(const Bounds& whole) {
  constexpr double relative = 1e-7;
  constexpr double roundings = 8.0;
  if (whole.empty() || !whole.finite()) {
    return relative;
  }
  const glm::dvec3 farthest = glm::max(glm::abs(whole.min), glm::abs(whole.max));
  return std::max(relative * glm::length(whole.half_size()),
                  roundings * std::numeric_limits<double>::epsilon() *
                      std::max({farthest.x, farthest.y, farthest.z}));
}

CoincidentSurfaces::CoincidentSurfaces(const Bounds& whole, double tolerance)
    : tolerance_(tolerance) {
  if (!whole.empty() && whole.finite()) {
    middle_ = whole.center();
    size_ = std::max(glm::length(whole.half_size()), std::numeric_limits<double>::min());
  }
}

void CoincidentSurfaces::add(const PlacedShape& shape, const Bounds& where) {
  const auto* mesh = std::get_if<MeshShape>(&shape.shape());
  parts_.push_back({.shape = shape,
                    .mesh = mesh != nullptr ? &(*mesh)->mesh() : nullptr,
                    .pieces = piece_count(shape.shape())});
  add_pieces(where);
}

void CoincidentSurfaces::add(const TriangleMesh& mesh, const Affine& transform,
                             const Bounds& where) {
  parts_.push_back({.shape = PlacedShape(HalfSpace{}, transform),
                    .mesh = &mesh,
                    .pieces = static_cast<std::uint32_t>(mesh.triangles.size())});
  add_pieces(where);
}

bool CoincidentSurfaces::set(const Part& part, std::uint32_t piece, SurfacePiece& out) const {
  return part.mesh != nullptr
             ? set_triangle(*part.mesh, piece, part.shape.transform(), middle_, out)
             : set_piece(part.shape, piece, middle_, size_, out);
}

void CoincidentSurfaces::add_pieces(const Bounds& where) {
  if (where.empty()) {
    return;
  }
  const Part& part = parts_.back();
  const Bounds near{.min = where.min - middle_ - tolerance_,
                    .max = where.max - middle_ + tolerance_};
  const bool unbounded =
      part.mesh == nullptr && std::holds_alternative<HalfSpace>(part.shape.shape());
  SurfacePiece piece;
  for (std::uint32_t i = 0; i < part.pieces; ++i) {
    if (!set(part, i, piece)) {
      continue;
    }
    // What is planar ends at its samples; of the rest, the shape's box will do.
    if (piece.planar && !unbounded && intersection(box_around(piece), near).empty()) {
      continue;
    }
    levels_ |= 1U << level_for(noise_of(piece, size_, tolerance_));
    pieces_.push_back({.extent = static_cast<float>(piece.extent),
                       .part = static_cast<std::uint32_t>(parts_.size() - 1),
                       .piece = i});
  }
}

void CoincidentSurfaces::find() {
  std::ranges::sort(pieces_, [](const Piece& a, const Piece& b) {
    return std::tuple(-a.extent, a.part, a.piece) < std::tuple(-b.extent, b.part, b.piece);
  });
  struct Surface {
    std::uint32_t part = 0;  // of its largest piece
    bool shared = false;
    std::uint32_t number = none;
  };
  std::vector<Surface> surfaces;
  std::vector<Place> places(pieces_.size());
  Table<Plane> planes(size_, tolerance_, levels_, pieces_.size());
  Table<CurvedSurface> curved(size_, tolerance_, levels_, pieces_.size());
  SurfacePiece piece;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const auto next = static_cast<std::uint32_t>(surfaces.size());
    set(parts_[pieces_[i].part], pieces_[i].piece, piece);
    const Place place = piece.planar ? planes.join(piece.plane, piece, next)
                                     : curved.join(piece.curved, piece, next);
    if (place.surface == next) {
      surfaces.push_back({.part = pieces_[i].part});
    }
    Surface& surface = surfaces[place.surface];
    surface.shared = surface.shared || surface.part != pieces_[i].part || place.reversed;
    places[i] = place;
  }
  for (Surface& surface : surfaces) {
    if (surface.shared) {
      surface.number = surfaces_++;
    }
  }
  first_place_.assign(any() ? parts_.size() : 0, nowhere);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Surface& surface = surfaces[places[i].surface];
    if (!surface.shared) {
      continue;
    }
    const auto [extent, part, index] = pieces_[i];
    if (first_place_[part] == nowhere) {
      first_place_[part] = places_.size();
      places_.resize(places_.size() + parts_[part].pieces);
    }
    places_[first_place_[part] + index] = {.surface = surface.number,
                                           .reversed = places[i].reversed};
  }
  pieces_ = {};
  parts_ = {};
}

}  // namespace raycat
