#include "tracer/texture.hpp"

#include <catch2/catch.hpp>

namespace raycat {
namespace {

// Black and white, side by side.
Texture halves(Wrap wrap, bool nearest) {
  return Texture(2, 1, {0, 0, 0, 255, 255, 255, 255, 0}, wrap, wrap, nearest);
}

TEST_CASE("texel centres have the texel's own value", "[tracer][texture]") {
  const bool nearest = GENERATE(false, true);
  const Texture texture = halves(Wrap::repeat, nearest);
  CHECK(texture.sample({0.25, 0.5}) == glm::vec4(0, 0, 0, 1));
  CHECK(texture.sample({0.75, 0.5}) == glm::vec4(1, 1, 1, 0));
}

TEST_CASE("between centres values are mixed in linear light", "[tracer][texture]") {
  const Texture texture(2, 1, {0, 0, 0, 255, 188, 188, 188, 255});
  CHECK(texture.sample({0.5, 0.5}).r == Approx(0.5029 / 2).margin(1e-3));
}

TEST_CASE("beyond the edge the wrap mode decides", "[tracer][texture]") {
  CHECK(halves(Wrap::repeat, true).sample({1.25, 0.5}).r == 0.0f);
  CHECK(halves(Wrap::repeat, true).sample({-0.25, 0.5}).r == 1.0f);
  CHECK(halves(Wrap::clamp, true).sample({7.25, 0.5}).r == 1.0f);
  CHECK(halves(Wrap::clamp, true).sample({-7.0, 0.5}).r == 0.0f);
  CHECK(halves(Wrap::mirror, true).sample({1.25, 0.5}).r == 1.0f);
  CHECK(halves(Wrap::mirror, true).sample({-0.25, 0.5}).r == 0.0f);
}

TEST_CASE("coordinates without sense give the first texel", "[tracer][texture]") {
  CHECK(halves(Wrap::repeat, false).sample({NAN, 0.5}).r == 0.0f);
  CHECK(halves(Wrap::repeat, false).sample({1e300, 0.5}).r == 0.0f);
}

TEST_CASE("a texture without its pixels is refused", "[tracer][texture]") {
  CHECK_THROWS_WITH(Texture(2, 2, {1, 2, 3}), "a texture of 2x2 needs 16 bytes, but has 3");
  CHECK_THROWS_AS(Texture(0, 2, {}), std::invalid_argument);
}

}  // namespace
}  // namespace raycat
