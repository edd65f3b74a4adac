#include "render/image_quality.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tracer/srgb.hpp"

namespace raycat {
namespace {

constexpr double of_equals = 200.0;

glm::vec3 encoded(const glm::vec3& colour) {
  return {srgb_from_linear(colour.r), srgb_from_linear(colour.g), srgb_from_linear(colour.b)};
}

template <typename Of>
double psnr_of(const Pixels& image, const Pixels& reference, const Of& of) {
  double sum = 0.0;
  for (std::size_t i = 0; i < image.size(); ++i) {
    const glm::dvec3 apart(of(image[i]) - of(reference[i]));
    sum += glm::dot(apart, apart);
  }
  const double mean = sum / (3.0 * static_cast<double>(image.size()));
  return mean > 0.0 ? std::min(of_equals, -10.0 * std::log10(mean)) : of_equals;
}

double luma(const glm::vec3& colour) {
  return glm::dot(glm::dvec3(encoded(colour)), glm::dvec3(0.299, 0.587, 0.114));
}

}  // namespace

double psnr(const Pixels& image, const Pixels& reference) {
  return psnr_of(image, reference, [](const glm::vec3& colour) { return colour; });
}

double psnr_encoded(const Pixels& image, const Pixels& reference) {
  return psnr_of(image, reference, encoded);
}

double ssim(const Pixels& image, const Pixels& reference, int width) {
  constexpr int window = 8;
  const int height = static_cast<int>(image.size()) / std::max(width, 1);
  if (width < window || height < window) {
    return 1.0;
  }
  // Sums over all pixels above and to the left: of both, of their squares and of their product.
  using Sums = std::array<double, 5>;
  const auto columns = static_cast<std::size_t>(width) + 1;
  std::vector<Sums> sums(columns * (static_cast<std::size_t>(height) + 1));
  const auto at = [&](int x, int y) -> Sums& {
    return sums[static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x)];
  };
  std::size_t i = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x, ++i) {
      const double a = luma(image[i]);
      const double b = luma(reference[i]);
      const Sums here{a, b, a * a, b * b, a * b};
      for (std::size_t k = 0; k < here.size(); ++k) {
        at(x + 1, y + 1)[k] = here[k] + at(x, y + 1)[k] + at(x + 1, y)[k] - at(x, y)[k];
      }
    }
  }
  constexpr double n = window * window;
  constexpr double c1 = 0.01 * 0.01;
  constexpr double c2 = 0.03 * 0.03;
  double total = 0.0;
  for (int y = 0; y + window <= height; ++y) {
    for (int x = 0; x + window <= width; ++x) {
      Sums m{};
      for (std::size_t k = 0; k < m.size(); ++k) {
        m[k] = (at(x + window, y + window)[k] - at(x, y + window)[k] - at(x + window, y)[k] +
                at(x, y)[k]) /
               n;
      }
      const double a2 = m[2] - m[0] * m[0];
      const double b2 = m[3] - m[1] * m[1];
      const double ab = m[4] - m[0] * m[1];
      total += (2.0 * m[0] * m[1] + c1) * (2.0 * ab + c2) /
               ((m[0] * m[0] + m[1] * m[1] + c1) * (a2 + b2 + c2));
    }
  }
  return total / (static_cast<double>(width - window + 1) * (height - window + 1));
}

Pixels difference_image(const Pixels& image, const Pixels& reference, float gain) {
  Pixels out(image.size());
  for (std::size_t i = 0; i < image.size(); ++i) {
    out[i] = glm::clamp(gain * glm::abs(image[i] - reference[i]), 0.0f, 1.0f);
  }
  return out;
}

}  // namespace raycat
