#include "antialias/adaptive.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "antialias/pictures.hpp"

namespace raycat {
namespace {

AntialiasSettings of(int width, int height, int threads = 1) {
  return {.width = width, .height = height, .threads = threads, .progress = {}};
}

constexpr AdaptiveSettings fine{.error = 0.001f};

// The part of the pixel's square below the line through `point` with this normal, by clipping.
double share_below(double x, double y, const glm::dvec2& point, const glm::dvec2& normal) {
  constexpr int lines = 4000;
  double sum = 0.0;
  for (int i = 0; i < lines; ++i) {
    // Along each vertical line, exactly.
    const double column = x + (i + 0.5) / lines;
    const double rest = -normal.x * (column - point.x);
    if (std::abs(normal.y) < 1e-12) {
      sum += rest > 0.0 ? 1.0 : 0.0;
      continue;
    }
    const double crossing = point.y + rest / normal.y;
    const double above = std::clamp(crossing - y, 0.0, 1.0);
    sum += normal.y > 0.0 ? above : 1.0 - above;
  }
  return sum / lines;
}

TEST_CASE("a patch that is quadratic is integrated exactly without a ray", "[antialias]") {
  Picture patch([](const glm::dvec2& p) -> ColourSample {
    const double v = 0.2 + 0.01 * p.x + 0.004 * p.x * p.x - 0.003 * p.y * p.y + 0.002 * p.x * p.y;
    return {.colour = glm::vec4(glm::vec3(static_cast<float>(v)), 1.0f), .tree = TreeId{1}};
  });
  const AntialiasedPicture is = antialias_adaptively(patch, of(7, 7), {.error = 0.01f});
  CHECK(is.samples.colour == 64);
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 7; ++x) {
      const auto third = [](double a) { return ((a + 1) * (a + 1) * (a + 1) - a * a * a) / 3.0; };
      const double expected = 0.2 + 0.01 * (x + 0.5) + 0.004 * third(x) - 0.003 * third(y) +
                              0.002 * (x + 0.5) * (y + 0.5);
      CHECK(is.colour[is.index(x, y)].r == Approx(expected).margin(1e-5));
    }
  }
}

TEST_CASE("a straight edge at any angle is covered within a five-hundredth", "[antialias]") {
  for (int degrees = 0; degrees < 180; degrees += 7) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const glm::dvec2 normal(std::cos(angle), std::sin(angle));
    const glm::dvec2 point(4.03, 3.91);
    Picture picture = two_colours([&](const glm::dvec2& p) {
      return normal.x * (p.x - point.x) + normal.y * (p.y - point.y) < 0.0;
    });
    const AntialiasedPicture is = antialias_adaptively(picture, of(8, 8), fine);
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 8; ++x) {
        INFO(degrees << " degrees, pixel " << x << ", " << y);
        const double expected = share_below(x, y, point, normal);
        CHECK(is.colour[is.index(x, y)].g == Approx(expected).margin(1.0 / 500));
        CHECK(is.colour[is.index(x, y)].a == Approx(expected).margin(1.0 / 500));
      }
    }
  }
}

TEST_CASE("where three surfaces meet a pixel is right within a hundredth", "[antialias]") {
  for (int turned = 0; turned < 12; ++turned) {
    const glm::dvec2 centre(2.5 + 0.03 * turned, 2.41 + 0.02 * turned);
    const auto sector = [&](const glm::dvec2& p) {
      const double angle = std::atan2(p.y - centre.y, p.x - centre.x) + 0.1 * turned;
      return static_cast<std::uint32_t>(
                 std::floor((angle + 9.0 * std::numbers::pi) / (2.0 * std::numbers::pi / 3.0))) %
             3;
    };
    Picture picture([&](const glm::dvec2& p) -> ColourSample {
      const std::uint32_t is = sector(p);
      return {.colour = glm::vec4(is == 0 ? 1.0f : 0.0f, is == 1 ? 1.0f : 0.0f,
                                  is == 2 ? 1.0f : 0.0f, 1.0f),
              .tree = TreeId{is}};
    });
    const AntialiasedPicture is = antialias_adaptively(picture, of(5, 5), fine);
    glm::dvec3 expected(0.0);
    constexpr int side = 400;
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        const glm::dvec2 p(2.0 + (i + 0.5) / side, 2.0 + (j + 0.5) / side);
        expected[static_cast<int>(sector(p))] += 1.0 / (side * side);
      }
    }
    for (int c = 0; c < 3; ++c) {
      CHECK(is.colour[is.index(2, 2)][c] == Approx(expected[c]).margin(0.01));
    }
  }
}

TEST_CASE("a thin thing between all corners is found amid many categories", "[antialias]") {
  // Columns of two greys about the corners, and above row 5.5 of other categories; a small white
  // disc in pixel (5, 6).
  const auto picture_with = [](std::uint32_t above) {
    return Picture([=](const glm::dvec2& p) -> ColourSample {
      if (std::hypot(p.x - 5.4, p.y - 6.45) < 0.2) {
        return {.colour = glm::vec4(1.0f), .tree = TreeId{99}};
      }
      const auto column = static_cast<std::uint32_t>(std::lround(p.x));
      const float grey = column % 2 == 0 ? 0.3f : 0.4f;
      return {.colour = glm::vec4(glm::vec3(grey), 1.0f),
              .tree = TreeId{column + (p.y < 5.5 ? above : 0)}};
    });
  };
  const auto found = [&](std::uint32_t above) {
    Picture picture = picture_with(above);
    AntialiasSettings settings = of(12, 12);
    settings.coverage = true;
    const AntialiasedPicture is = antialias_adaptively(picture, settings, {.error = 0.01f});
    double share = 0.0;
    for (const TreeShare& each : is.coverage[is.index(5, 6)]) {
      share += each.tree == TreeId{99} ? static_cast<double>(each.share) : 0.0;
    }
    return share;
  };
  CHECK(found(20) > 0.05);  // of 0.126
  CHECK(found(0) == 0.0);   // amid the four categories of the columns alone it is not looked for
}

TEST_CASE("an edge that cannot be seen costs no ray", "[antialias]") {
  Picture picture =
      two_colours([](const glm::dvec2& p) { return p.x + 0.7 * p.y < 6.3; },
                  glm::vec4(glm::vec3(0.5f), 1.0f), glm::vec4(glm::vec3(0.503f), 1.0f));
  CHECK(antialias_adaptively(picture, of(9, 9), {.error = 0.01f}).samples.colour == 100);
}

TEST_CASE("the picture and its rays are the same whatever the number of threads", "[antialias]") {
  // Discs and stripes everywhere, so that neighbours have much to tell each other.
  const auto picture = [] {
    return Picture([](const glm::dvec2& p) -> ColourSample {
      const double rings = std::sin(3.0 * std::hypot(p.x - 20.0, p.y - 11.0));
      const double stripes = std::sin(1.7 * p.x + 0.3 * p.y);
      const auto tree = static_cast<std::uint32_t>((rings > 0.2 ? 1 : 0) + (stripes > 0.1 ? 2 : 0));
      return {.colour = glm::vec4(glm::vec3(0.25f * static_cast<float>(tree)), 1.0f),
              .tree = TreeId{tree}};
    });
  };
  Picture one = picture();
  Picture four = picture();
  const AntialiasedPicture a = antialias_adaptively(one, of(40, 30, 1), {});
  const AntialiasedPicture b = antialias_adaptively(four, of(40, 30, 4), {});
  CHECK(a.colour == b.colour);
  CHECK(a.samples.colour == b.samples.colour);
  CHECK(a.refined == b.refined);
}

// How much of each pixel the tree numbered 1 covers.
double covered(const AntialiasedPicture& picture, std::size_t pixel) {
  double sum = 0.0;
  double all = 0.0;
  for (const TreeShare& each : picture.coverage[pixel]) {
    sum += each.tree == TreeId{1} ? static_cast<double>(each.share) : 0.0;
    all += static_cast<double>(each.share);
  }
  CHECK(all == Approx(1.0).epsilon(1e-5));
  return sum;
}

TEST_CASE("coverage of a half-plane and of a circle is right within a five-hundredth",
          "[antialias][coverage]") {
  AntialiasSettings settings = of(100, 100);
  settings.coverage = true;
  const glm::dvec2 normal(0.6, 0.8);
  const glm::dvec2 point(45.1, 44.7);
  Picture plane = two_colours([&](const glm::dvec2& p) {
    return normal.x * (p.x - point.x) + normal.y * (p.y - point.y) < 0.0;
  });
  const AntialiasedPicture half = antialias_adaptively(plane, settings, {.error = 0.0005f});
  const glm::dvec2 centre(50.3, 49.6);
  constexpr double radius = 44.0;
  Picture disc = two_colours(
      [&](const glm::dvec2& p) { return std::hypot(p.x - centre.x, p.y - centre.y) < radius; });
  const AntialiasedPicture round = antialias_adaptively(disc, settings, {.error = 0.0005f});
  double worst_half = 0.0;
  double worst_round = 0.0;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) {
      const std::size_t pixel = half.index(x, y);
      if (std::abs(normal.x * (x + 0.5 - point.x) + normal.y * (y + 0.5 - point.y)) < 1.0) {
        worst_half =
            std::max(worst_half, std::abs(covered(half, pixel) - share_below(x, y, point, normal)));
      }
      constexpr int lines = 500;
      double inside = 0.0;
      for (int i = 0; i < lines; ++i) {
        const double dx = x + (i + 0.5) / lines - centre.x;
        const double reach = std::sqrt(std::max(0.0, radius * radius - dx * dx));
        inside += std::max(0.0, std::min(centre.y + reach, y + 1.0) -
                                    std::max(centre.y - reach, static_cast<double>(y)));
      }
      worst_round = std::max(worst_round, std::abs(covered(round, pixel) - inside / lines));
    }
  }
  CHECK(worst_half < 1.0 / 500);
  CHECK(worst_round < 1.0 / 500);
}

// From `low` to `high`, in steps of a thousandth of that.
double in_range(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0;
}

TEST_CASE("discs anywhere are covered well", "[antialias][property]") {
  CHECK(rc::check("discs", [] {
    const double radius = in_range(4.0, 12.0);
    const glm::dvec2 centre(in_range(0.0, 8.0), in_range(0.0, 8.0));
    const auto inside = [&](const glm::dvec2& p) {
      return std::hypot(p.x - centre.x, p.y - centre.y) < radius;
    };
    Picture picture = two_colours(inside);
    const AntialiasedPicture is = antialias_adaptively(picture, of(8, 8), fine);
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 8; ++x) {
        constexpr int lines = 500;
        double expected = 0.0;
        for (int i = 0; i < lines; ++i) {
          const double dx = x + (i + 0.5) / lines - centre.x;
          const double half = std::sqrt(std::max(0.0, radius * radius - dx * dx));
          expected += std::max(0.0, std::min(centre.y + half, y + 1.0) -
                                        std::max(centre.y - half, static_cast<double>(y)));
        }
        RC_ASSERT(std::abs(static_cast<double>(is.colour[is.index(x, y)].a) - expected / lines) <
                  0.05);  // what bulges over a side between two corners is missed
      }
    }
  }));
}

}  // namespace
}  // namespace raycat
