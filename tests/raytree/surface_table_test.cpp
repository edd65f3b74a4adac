#include "raytree/surface_table.hpp"

#include <limits>
#include <stdexcept>

#include <catch2/catch.hpp>

namespace raycat {
namespace {

// A house of one box and one cone, and a ball.
SurfaceTable small_scene() {
  SurfaceTable table;
  table.add_object("house");
  table.add_primitive("walls", 6);
  table.add_primitive("roof", 2);
  table.add_object("ball");
  table.add_primitive("ball", 1);
  return table;
}

TEST_CASE("faces are numbered in the order their primitives are added",
          "[geometry][surface_table]") {
  SurfaceTable table;
  CHECK(table.add_object("house") == ObjectId{0});
  CHECK(table.add_primitive("walls", 6) == SurfaceId{0});
  CHECK(table.add_primitive("roof", 2) == SurfaceId{6});
  CHECK(table.add_object("ball") == ObjectId{1});
  CHECK(table.add_primitive("ball", 1) == SurfaceId{8});
  CHECK(table.objects() == 2);
  CHECK(table.primitives() == 3);
  CHECK(table.faces() == 9);
}

TEST_CASE("a face names its primitive and its object", "[geometry][surface_table]") {
  const SurfaceTable table = small_scene();
  CHECK(table.primitive(SurfaceId{5}) == PrimitiveId{0});
  CHECK(table.primitive(SurfaceId{6}) == PrimitiveId{1});
  CHECK(table.object(SurfaceId{7}) == ObjectId{0});
  CHECK(table.object(SurfaceId{8}) == ObjectId{1});
  CHECK(table.face_in_primitive(SurfaceId{5}) == 5);
  CHECK(table.face_in_primitive(SurfaceId{7}) == 1);
  CHECK(table.name(table.primitive(SurfaceId{7})) == "roof");
  CHECK(table.name(table.object(SurfaceId{7})) == "house");
}

TEST_CASE("a granularity numbers its surfaces without gaps", "[geometry][surface_table]") {
  const SurfaceTable table = small_scene();
  const auto granularity = GENERATE(Granularity::object, Granularity::primitive, Granularity::face);
  std::size_t next = 0;
  for (std::uint32_t face = 0; face < table.faces(); ++face) {
    const auto surface = static_cast<std::size_t>(table.at(granularity, SurfaceId{face}));
    CHECK(surface <= next);
    next = surface == next ? next + 1 : next;
  }
  CHECK(next == table.count(granularity));
}

TEST_CASE("more faces than ids are refused by the primitive's name", "[geometry][surface_table]") {
  SurfaceTable table = small_scene();
  CHECK_THROWS_WITH(table.add_primitive("dust", std::numeric_limits<std::uint32_t>::max()),
                    "a scene holds at most 4294967295 faces, but 'dust' would make it 4294967304");
  CHECK_THROWS_AS(table.add_primitive("dust", 4294967295U - 8U), std::length_error);
  CHECK(table.faces() == 9);
}

}  // namespace
}  // namespace raycat
