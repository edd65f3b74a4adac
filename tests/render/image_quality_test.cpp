#include "render/image_quality.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace raycat {
namespace {

TEST_CASE("PSNR is twenty times the logarithm of the error", "[app][quality]") {
  const Pixels black(16, glm::vec3(0.0f));
  CHECK(psnr(black, black) == 200.0);
  CHECK(psnr(Pixels(16, glm::vec3(0.1f)), black) == Approx(20.0));
  CHECK(psnr(Pixels(16, glm::vec3(0.01f)), black) == Approx(40.0));
  // One channel of three.
  CHECK(psnr(Pixels(16, glm::vec3(0.1f, 0.0f, 0.0f)), black) ==
        Approx(20.0 + 10.0 * std::log10(3.0)));
  // 0.0031308 in linear light is 0.04045 encoded.
  CHECK(psnr_encoded(Pixels(16, glm::vec3(0.0031308f)), black) ==
        Approx(-20.0 * std::log10(0.04045)).epsilon(1e-4));
}

TEST_CASE("SSIM is 1 of equals, and falls with contrast and brightness lost", "[app][quality]") {
  Pixels stripes;
  for (int i = 0; i < 256; ++i) {
    stripes.emplace_back(i % 2 == 0 ? 0.8f : 0.1f);
  }
  CHECK(ssim(stripes, stripes, 16) == Approx(1.0));
  const Pixels grey(256, glm::vec3(0.3f));
  CHECK(ssim(grey, stripes, 16) < 0.05);
  // Of flat images only the first factor counts: (2ab + c) / (a^2 + b^2 + c).
  const Pixels white(256, glm::vec3(1.0f));
  const Pixels black(256, glm::vec3(0.0f));
  CHECK(ssim(white, black, 16) == Approx(1e-4 / (1.0 + 1e-4)));
  CHECK(ssim(white, black, 4) == 1.0);
}

TEST_CASE("differences are absolute, magnified and limited", "[app][quality]") {
  const Pixels is = difference_image({glm::vec3(0.5f)}, {glm::vec3(0.4f, 0.6f, 1.0f)}, 4.0f);
  CHECK(is[0].r == Approx(0.4f));
  CHECK(is[0].g == Approx(0.4f));
  CHECK(is[0].b == 1.0f);
}

}  // namespace
}  // namespace raycat
