#include "tracer/surface_layers.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include <glm/geometric.hpp>

#include "geometry/coincident_surfaces.hpp"
#include "geometry/surface_piece.hpp"

namespace raycat {
namespace {

// More things are not compared one by one.
constexpr std::size_t most_compared = 4096;

constexpr std::uint32_t nothing = ~std::uint32_t{0};
constexpr std::uint32_t several = nothing - 1;

// What rays may meet in one place: a solid or a mesh.
struct Thing {
  Bounds box;              // somewhat larger than it
  double tolerance = 0.0;  // how near another thing's surface is that coincides with one of it
  Bounds where;            // the part of it that others come near
};

// Coordinates are rounded by where they are, from the middle of the scene, but what is small is not
// thinner than its tolerance there.
double tolerance_of(const Bounds& box, const Bounds& whole) {
  constexpr double relative = 1e-7;
  constexpr double most = 1e-4;
  constexpr double least = 0x1p-47;
  if (whole.empty()) {
    return coincidence_tolerance(whole);
  }
  const double half = box.finite() ? glm::length(box.half_size()) : glm::length(whole.half_size());
  const double from = box.finite() ? glm::distance(box.center(), whole.center()) : 0.0;
  const glm::dvec3 farthest = glm::max(glm::abs(whole.min), glm::abs(whole.max));
  return std::max(std::min(relative * (half + from), most * half),
                  least * std::max({farthest.x, farthest.y, farthest.z}));
}

Bounds grown(const Bounds& box, double by) {
  return box.empty() ? box : Bounds{.min = box.min - by, .max = box.max + by};
}

// Sets `where` of all things, by their order along an axis.
void find_neighbours(std::vector<Thing>& things, int axis) {
  if (things.size() > most_compared) {
    for (Thing& thing : things) {
      thing.where = thing.box;
    }
    return;
  }
  std::vector<std::uint32_t> order(things.size());
  std::iota(order.begin(), order.end(), 0U);
  std::erase_if(order, [&](std::uint32_t i) { return things[i].box.empty(); });
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return things[i].box.min[axis]; });
  std::vector<std::uint32_t> open;
  for (const std::uint32_t i : order) {
    Thing& thing = things[i];
    std::erase_if(open, [&](std::uint32_t other) {
      return things[other].box.max[axis] < thing.box.min[axis];
    });
    for (const std::uint32_t other : open) {
      const Bounds both = intersection(thing.box, things[other].box);
      if (!both.empty()) {
        thing.where.include(both);
        things[other].where.include(both);
      }
    }
    open.push_back(i);
  }
}

int longest_axis(const Bounds& box) {
  const glm::dvec3 half = box.half_size();
  return half.x >= half.y && half.x >= half.z ? 0 : half.y >= half.z ? 1 : 2;
}

// A piece of a surface that more than one thing may have a part of.
struct Member {
  std::uint32_t surface = 0;
  bool reversed = false;
  bool opaque = true;
  SurfaceId face{};
  std::uint32_t thing = 0;
  std::size_t part = 0;
  std::uint32_t piece = 0;

  auto side() const { return std::tie(surface, reversed); }
  auto order() const { return std::tie(surface, reversed, opaque, face, part, piece); }
};

bool opaque(const Material& material) {
  return !material.blend && material.transmission == glm::vec3(0.0f) &&
         material.alpha_cutoff <= 0.0f;
}

std::vector<Thing> things_of(const Scene& scene, const Bounds& whole) {
  std::vector<Thing> out;
  const auto add = [&](const Bounds& box) {
    const double tolerance = tolerance_of(box, whole);
    out.push_back({.box = grown(box, tolerance), .tolerance = tolerance, .where = {}});
  };
  for (const SolidObject& object : scene.solids) {
    add(object.solid.bounds());
  }
  for (const MeshInstance& mesh : scene.meshes) {
    add(mesh.transform.bounds(bounds(mesh.mesh->triangles)));
  }
  find_neighbours(out, whole.empty() ? 0 : longest_axis(whole));
  return out;
}

// The members of surfaces that two things have, in order.
std::vector<Member> members_of(const Scene& scene, const std::vector<Thing>& things,
                               const CoincidentSurfaces& surfaces) {
  std::vector<Member> out;
  std::uint32_t part = 0;
  std::uint32_t thing = 0;
  const auto add = [&](std::uint32_t piece, bool turned, SurfaceId face, MaterialId material) {
    const CoincidentSurfaces::Place place = surfaces.place(part, piece);
    if (place.surface != CoincidentSurfaces::none) {
      out.push_back({.surface = place.surface,
                     .reversed = place.reversed != turned,
                     .opaque = opaque(material_of(scene, material)),
                     .face = face,
                     .thing = thing,
                     .part = part,
                     .piece = piece});
    }
  };
  for (const SolidObject& object : scene.solids) {
    for (std::uint32_t i = 0; i < object.materials.size(); ++i, ++part) {
      const CsgLeaf& leaf = object.solid.tree().leaves()[i];
      const std::uint32_t pieces =
          things[thing].where.empty() ? 0 : piece_count(leaf.shape.shape());
      for (std::uint32_t piece = 0; piece < pieces; ++piece) {
        add(piece, object.solid.subtracted(i), leaf.first_face, object.materials[i]);
      }
    }
    ++thing;
  }
  for (const MeshInstance& mesh : scene.meshes) {
    const TriangleMesh& triangles = mesh.mesh->triangles;
    const std::size_t pieces = things[thing].where.empty() ? 0 : triangles.triangles.size();
    for (std::uint32_t piece = 0; piece < pieces; ++piece) {
      add(piece, false,
          SurfaceId{static_cast<std::uint32_t>(mesh.first_face) + triangles.faces[piece]},
          mesh.material);
    }
    ++part;
    ++thing;
  }
  std::vector<std::uint32_t> only(surfaces.surfaces(), nothing);  // the thing that has a surface
  for (const Member& member : out) {
    std::uint32_t& has = only[member.surface];
    has = has == nothing || has == member.thing ? member.thing : several;
  }
  std::erase_if(out, [&](const Member& member) { return only[member.surface] != several; });
  std::ranges::sort(out, {}, &Member::order);
  return out;
}

// Of each surface: two things are as near as the one with the smaller tolerance demands, so the
// second greatest is the greatest that two places on it differ by.
std::vector<double> places(const std::vector<Member>& members, const std::vector<Thing>& things,
                           std::uint32_t surfaces) {
  constexpr double tolerances = 4.0;
  struct Greatest {
    std::uint32_t thing = nothing;
    double first = 0.0;
    double second = 0.0;
  };
  std::vector<Greatest> greatest(surfaces);
  for (const Member& member : members) {
    Greatest& at = greatest[member.surface];
    const double tolerance = things[member.thing].tolerance;
    if (at.thing == member.thing) {
      continue;
    }
    if (at.thing == nothing || tolerance > at.first) {
      at.second = at.first;
      at.first = tolerance;
      at.thing = member.thing;
    } else {
      at.second = std::max(at.second, tolerance);
    }
  }
  std::vector<double> out(surfaces);
  std::ranges::transform(greatest, out.begin(),
                         [](const Greatest& at) { return tolerances * at.second; });
  return out;
}

}  // namespace

SurfaceLayers::SurfaceLayers(const Scene& scene) {
  const Bounds whole = bounds(scene);
  const std::vector<Thing> things = things_of(scene, whole);
  if (std::ranges::all_of(things, [](const Thing& thing) { return thing.where.empty(); })) {
    return;
  }
  CoincidentSurfaces surfaces(whole, coincidence_tolerance(whole));
  std::vector<std::uint32_t> pieces;
  auto thing = things.begin();
  for (const SolidObject& object : scene.solids) {
    leaves_.push_back(pieces.size());
    for (const CsgLeaf& leaf : object.solid.tree().leaves()) {
      surfaces.add(leaf.shape, thing->where, thing->tolerance);
      pieces.push_back(piece_count(leaf.shape.shape()));
    }
    ++thing;
  }
  meshes_ = pieces.size();
  for (const MeshInstance& mesh : scene.meshes) {
    surfaces.add(mesh.mesh->triangles, mesh.transform, thing->where, thing->tolerance);
    pieces.push_back(static_cast<std::uint32_t>(mesh.mesh->triangles.triangles.size()));
    ++thing;
  }
  surfaces.find();
  if (!surfaces.any()) {
    return;
  }
  first_.assign(pieces.size(), none);
  const std::vector<Member> members = members_of(scene, things, surfaces);
  place_ = places(members, things, surfaces.surfaces());
  const Member* before = nullptr;
  std::int32_t rank = 0;
  for (const Member& member : members) {
    if (before == nullptr || before->side() != member.side()) {
      rank = 1;
    } else if (std::tie(before->opaque, before->face) != std::tie(member.opaque, member.face)) {
      ++rank;
    }
    before = &member;
    if (first_[member.part] == none) {
      first_[member.part] = static_cast<std::uint32_t>(layers_.size());
      layers_.resize(layers_.size() + pieces[member.part]);
    }
    layers_[first_[member.part] + member.piece] = {.surface = member.surface,
                                                   .height = member.reversed ? rank : -rank};
  }
}

}  // namespace raycat
