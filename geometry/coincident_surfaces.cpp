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
  bool planar = false;

  void add(const glm::dvec3& v) {
    for (int k = 0; k < 3; ++k) {
      values[count++] = v[k];
    }
  }
};

Key key_of(const Plane& plane, double size) {
  Key key{.planar = true};
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
constexpr std::array cell_sizes{0x1p-7, 0x1p-10, 0x1p-13, 0x1p-16, 0x1p-19};

std::size_t level_for(double noise) {
  std::size_t level = cell_sizes.size() - 1;
  while (level > 0 && noise > cell_sizes[level] / 4.0) {
    --level;
  }
  return level;
}

// By how much the keys of pieces may differ that lie in one surface. A piece so narrow that its
// direction says nothing is only looked for nearby.
double noise_of(const SurfacePiece& piece, double size, double tolerance) {
  const double noise = 4.0 * tolerance / std::min(piece.width, size);
  return std::min(noise, cell_sizes[0] / 2.0);
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
        cells_(std::bit_ceil(std::max<std::size_t>(most, 1))) {}

  // The first surface that is near all samples of the piece; else the piece's own, numbered `next`.
  // `tolerance` is the piece's own.
  Place join(const Surface& surface, const SurfacePiece& piece, double tolerance,
             std::uint32_t next) {
    const double noise = noise_of(piece, size_, tolerance);
    const std::size_t level = level_for(noise);
    const Key key = key_of(surface, size_);
    std::uint32_t found = none;
    find(key, level, noise, piece.samples, tolerance, found);
    if (key.directed) {
      find(reversed(key, surface), level, noise, piece.samples, tolerance, found);
    }
    if (found == none) {
      add(surface, key, tolerance, next);
      return {.surface = next};
    }
    for (const glm::dvec3& sample : piece.samples) {
      farthest_ = std::max(farthest_, known_[found].surface.distance(sample));
    }
    return {.surface = known_[found].number,
            .reversed = face_apart(known_[found].surface, surface)};
  }

  // How far pieces are from the surfaces that they have joined, at most.
  double farthest() const { return farthest_; }

  const Surface& operator[](std::uint32_t known) const { return known_[known].surface; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(known_.size()); }

 private:
  // A known surface in a cell, with enough of its key to pass by most without looking at them.
  struct Entry {
    std::array<float, 4> values{};
    std::uint32_t known = 0;
  };

  // Its entries, side by side with room for a power of two of them. Cells may share one.
  struct Cell {
    std::uint32_t begin = 0;
    std::uint32_t count = 0;
  };

  struct Known {
    Surface surface;
    double tolerance = 0.0;
    std::uint32_t number = 0;
  };

  static std::int64_t index(double value, std::size_t level) {
    return static_cast<std::int64_t>(std::floor(value / cell_sizes[level]));
  }

  std::size_t slot(const std::array<std::int64_t, 6>& cell, std::size_t count,
                   std::size_t level) const {
    std::uint64_t hash = level;
    for (std::size_t k = 0; k < count; ++k) {
      hash = (hash ^ static_cast<std::uint64_t>(cell[k])) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 29U;
    }
    return hash & (cells_.size() - 1);
  }

  void add(const Surface& surface, const Key& key, double tolerance, std::uint32_t number) {
    std::array<std::int64_t, 6> cell{};
    for (std::size_t level = 0; level < cell_sizes.size(); ++level) {
      if ((levels_ >> level & 1U) == 0) {
        continue;
      }
      for (std::size_t k = 0; k < key.count; ++k) {
        cell[k] = index(key.values[k], level);
      }
      Entry entry{.known = static_cast<std::uint32_t>(known_.size())};
      for (std::size_t k = 0; k < entry.values.size(); ++k) {
        entry.values[k] = static_cast<float>(key.values[k]);
      }
      push(cells_[slot(cell, key.count, level)], entry);
    }
    known_.push_back({.surface = surface, .tolerance = tolerance, .number = number});
  }

  void push(Cell& cell, const Entry& entry) {
    if (cell.count == 0 || std::has_single_bit(cell.count)) {  // no room
      const auto begin = static_cast<std::uint32_t>(entries_.size());
      entries_.resize(begin + std::max(2 * cell.count, 1U));
      std::copy_n(entries_.begin() + cell.begin, cell.count, entries_.begin() + begin);
      cell.begin = begin;
    }
    entries_[cell.begin + cell.count++] = entry;
  }

  // Lowers `found` to the first of those in the cells around the key that is near all samples.
  void find(const Key& key, std::size_t level, double noise, std::span<const glm::dvec3> samples,
            double tolerance, std::uint32_t& found) const {
    std::array<std::int64_t, 6> low{};
    std::array<std::int64_t, 6> high{};
    for (std::size_t k = 0; k < key.count; ++k) {
      low[k] = index(key.values[k] - noise, level);
      high[k] = index(key.values[k] + noise, level);
    }
    std::array<std::int64_t, 6> cell = low;
    for (;;) {
      const auto [begin, count] = cells_[slot(cell, key.count, level)];
      for (const Entry& entry : std::span(entries_).subspan(begin, count)) {
        if (entry.known < found && differ_little(entry.values, key, noise) &&
            holds(known_[entry.known], samples, tolerance)) {
          found = entry.known;
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

  bool differ_little(const std::array<float, 4>& values, const Key& key, double noise) const {
    constexpr double rounding = 0x1p-23;
    std::array<double, 4> difference{};
    for (std::size_t k = 0; k < difference.size(); ++k) {
      difference[k] = std::abs(double{values[k]} - key.values[k]);
      if (difference[k] > noise + rounding) {
        return false;
      }
    }
    // Planes that both come by a place within 2 of the middle.
    return !key.planar || difference[3] <= 2.0 * (difference[0] + difference[1] + difference[2]) +
                                               4.0 * tolerance_ / size_ + 8.0 * rounding;
  }

  static bool holds(const Known& known, std::span<const glm::dvec3> samples, double tolerance) {
    const double most = std::min(tolerance, known.tolerance);
    return std::ranges::all_of(
        samples, [&](const glm::dvec3& sample) { return known.surface.distance(sample) <= most; });
  }

  double size_;
  double tolerance_;
  unsigned levels_;
  double farthest_ = 0.0;
  std::vector<Known> known_;
  std::vector<Cell> cells_;  // by hash
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

void CoincidentSurfaces::add(const PlacedShape& shape, const Bounds& where, double own_tolerance) {
  if (const auto* mesh = std::get_if<MeshShape>(&shape.shape())) {
    add((*mesh)->mesh(), shape.transform(), where, own_tolerance);
    return;
  }
  parts_.push_back({.shape = &shape,
                    .tolerance = std::min(tolerance_, own_tolerance),
                    .pieces = piece_count(shape.shape())});
  add_pieces(where);
}

void CoincidentSurfaces::add(const TriangleMesh& mesh, const Affine& transform, const Bounds& where,
                             double own_tolerance) {
  parts_.push_back({.mesh = &mesh,
                    .transform = static_cast<std::uint32_t>(transforms_.size()),
                    .tolerance = std::min(tolerance_, own_tolerance),
                    .pieces = static_cast<std::uint32_t>(mesh.triangles.size())});
  transforms_.push_back(transform);
  add_pieces(where);
}

bool CoincidentSurfaces::set(const Part& part, std::uint32_t piece, SurfacePiece& out) const {
  return part.mesh != nullptr
             ? set_triangle(*part.mesh, piece, transforms_[part.transform], middle_, out)
             : set_piece(*part.shape, piece, middle_, size_, out);
}

void CoincidentSurfaces::add_pieces(const Bounds& where) {
  if (where.empty()) {
    return;
  }
  const Part& part = parts_.back();
  const Bounds near{.min = where.min - middle_ - part.tolerance,
                    .max = where.max - middle_ + part.tolerance};
  const bool unbounded =
      part.mesh == nullptr && std::holds_alternative<HalfSpace>(part.shape->shape());
  SurfacePiece piece;
  for (std::uint32_t i = 0; i < part.pieces; ++i) {
    if (!set(part, i, piece)) {
      continue;
    }
    // What is planar ends at its samples; of the rest, the shape's box will do.
    if (piece.planar && !unbounded && intersection(box_around(piece), near).empty()) {
      continue;
    }
    planar_ += piece.planar ? 1 : 0;
    levels_ |= 1U << level_for(noise_of(piece, size_, part.tolerance));
    pieces_.push_back({.extent = static_cast<float>(piece.extent),
                       .id = {.part = static_cast<std::uint32_t>(parts_.size() - 1), .piece = i}});
  }
}

double CoincidentSurfaces::passage(std::uint32_t surface, const Ray& ray, double t,
                                   bool inwards) const {
  const Ray line{.origin = ray.origin - middle_, .direction = ray.direction};
  const auto* plane = std::get_if<Plane>(&shared_[surface].shape);
  return plane != nullptr
             ? plane->passage(line)
             : std::get_if<CurvedSurface>(&shared_[surface].shape)->passage(line, t, inwards);
}

void CoincidentSurfaces::find() {
  std::ranges::sort(pieces_, [](const Piece& a, const Piece& b) {
    return std::tuple(-a.extent, a.id.part, a.id.piece) <
           std::tuple(-b.extent, b.id.part, b.id.piece);
  });
  struct Known {
    PieceId largest;
    std::uint32_t in_table = 0;  // of its kind
    bool shared = false;
    std::uint32_t number = none;
  };
  std::vector<Known> known;
  std::vector<Place> joined(pieces_.size());
  Table<Plane> planes(size_, tolerance_, levels_, planar_);
  Table<CurvedSurface> curved(size_, tolerance_, levels_, pieces_.size() - planar_);
  SurfacePiece piece;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const PieceId id = pieces_[i].id;
    const double tolerance = parts_[id.part].tolerance;
    set(parts_[id.part], id.piece, piece);
    const auto next = static_cast<std::uint32_t>(known.size());
    joined[i] = piece.planar ? planes.join(piece.plane, piece, tolerance, next)
                             : curved.join(piece.curved, piece, tolerance, next);
    if (joined[i].surface == next) {
      known.push_back(
          {.largest = id, .in_table = (piece.planar ? planes.size() : curved.size()) - 1});
    }
    Known& surface = known[joined[i].surface];
    if (surface.shared || (surface.largest.part == id.part && !joined[i].reversed)) {
      continue;
    }
    surface.shared = true;
    surface.number = surfaces();
    if (piece.planar) {
      shared_.push_back({.shape = planes[surface.in_table], .largest = surface.largest});
    } else {
      shared_.push_back({.shape = curved[surface.in_table], .largest = surface.largest});
    }
  }
  farthest_ = std::max(planes.farthest(), curved.farthest());
  first_place_.assign(any() ? parts_.size() : 0, nowhere);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Known& surface = known[joined[i].surface];
    if (!surface.shared) {
      continue;
    }
    const auto [part, index] = pieces_[i].id;
    if (first_place_[part] == nowhere) {
      first_place_[part] = places_.size();
      places_.resize(places_.size() + parts_[part].pieces);
    }
    places_[first_place_[part] + index] = {.surface = surface.number,
                                           .reversed = joined[i].reversed};
  }
  places_.shrink_to_fit();
  pieces_ = std::vector<Piece>();
  parts_ = std::vector<Part>();
  transforms_ = std::vector<Affine>();
}

}  // namespace raycat
