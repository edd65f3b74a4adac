#include "io/images/layer_file.hpp"

#include <OpenImageIO/imageio.h>
#include <catch2/catch.hpp>

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
  const auto in = OIIO::ImageInput::open(file.path().string());
  REQUIRE(in);
  const OIIO::ImageSpec& spec = in->spec();
  REQUIRE(spec.channelnames == std::vector<std::string>{"coverage0", "id0"});
  CHECK(spec.channelformat(0) == OIIO::TypeDesc::FLOAT);
  CHECK(spec.channelformat(1) == OIIO::TypeDesc::UINT32);
  std::vector<float> read_shares(4);
  std::vector<std::uint32_t> read_ids(4);
  CHECK(in->read_image(0, 0, 0, 1, OIIO::TypeDesc::FLOAT, read_shares.data()));
  CHECK(in->read_image(0, 0, 1, 2, OIIO::TypeDesc::UINT32, read_ids.data()));
  CHECK(read_shares == shares);
  CHECK(read_ids == ids);
  CHECK_THROWS_AS(write_layers("a.png", 2, 2, {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace raycat
