#include "io/images/layer_file.hpp"

#include <catch2/catch.hpp>

#include "tests/io/images/exr_values.hpp"
#include "tests/io/scene_text.hpp"

namespace raycat {
namespace {

TEST_CASE("layers come back as they were, numbers and whole ones", "[io][image]") {
  const TemporaryFile file("layers.exr", "");
  const std::vector<std::uint32_t> ids{0, 1, 4000000000u, 7};
  const std::vector<float> shares{0.0f, 1.0f, 0.3333333f, 1e-20f};
  write_layers(
      file.path(), 2, 2,
      std::vector<Layer>{{.name = "id0", .values = ids}, {.name = "coverage0", .values = shares}},
      {.command = "raycat", .scene = "none", .legend = ""});
  ExrValues exr(file.path());
  REQUIRE(exr.channels() == std::vector<std::string>{"coverage0", "id0"});
  CHECK(exr.type("coverage0") == Imf::FLOAT);
  CHECK(exr.type("id0") == Imf::UINT);
  CHECK(exr.values<float>("coverage0") == shares);
  CHECK(exr.values<std::uint32_t>("id0") == ids);
  CHECK_THROWS_AS(write_layers("a.png", 2, 2, {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace raycat
