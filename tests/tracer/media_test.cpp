#include "tracer/media.hpp"

#include <catch2/catch.hpp>

namespace raycat {
namespace {

constexpr ObjectId glass{0}, water{1};

TEST_CASE("a ray is in the medium it entered last", "[tracer][media]") {
  const Media air = Media();
  CHECK(air.ior() == 1.0f);
  const Media in_glass = air.entered(glass, 1.5f);
  const Media in_water = in_glass.entered(water, 1.33f);
  CHECK(in_water.ior() == 1.33f);
  CHECK(in_water.left(water).ior() == 1.5f);
  CHECK(in_water.left(water).left(glass).ior() == 1.0f);
}

TEST_CASE("objects that overlap are left in any order", "[tracer][media]") {
  const Media both = Media().entered(glass, 1.5f).entered(water, 1.33f);
  CHECK(both.left(glass).ior() == 1.33f);
  CHECK(both.left(glass).left(water).ior() == 1.0f);
}

TEST_CASE("leaving what was never entered changes nothing", "[tracer][media]") {
  CHECK(Media().left(glass).ior() == 1.0f);
  CHECK(Media().entered(water, 1.33f).left(glass).ior() == 1.33f);
}

TEST_CASE("as many media nest as there are levels", "[tracer][media]") {
  Media media;
  for (std::uint32_t i = 0; i < most_levels; ++i) {
    media = media.entered(ObjectId{i}, 1.0f + static_cast<float>(i));
  }
  CHECK(media.ior() == Approx(64.0f));
  CHECK(media.left(ObjectId{63}).ior() == Approx(63.0f));
}

}  // namespace
}  // namespace raycat
