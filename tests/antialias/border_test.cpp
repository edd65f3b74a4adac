#include "antialias/border.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace raycat {
namespace {

// The pixels of one row that a function of x passes through, white below it on the picture.
std::vector<BorderRow> row_of(double (*y)(double), int columns) {
  std::vector<BorderRow> rows(1);
  for (int x = 0; x < columns; ++x) {
    rows[0].set(
        x,
        Border{.ends = {{{0.0f, static_cast<float>(y(x))}, {1.0f, static_cast<float>(y(x + 1))}}},
               .sides = {3, 1},
               .left = glm::vec4(0.0f),
               .right = glm::vec4(1.0f)});
  }
  return rows;
}

TEST_CASE("a parabola's pixels gain what is between it and its chords", "[antialias]") {
  const auto y = [](double x) { return 0.2 + 0.05 * (x - 1.5) * (x - 1.5); };
  const auto rows = row_of(y, 3);
  // Between x = 1 and 2 the chord is above the curve, as the picture is seen, by c / 6 of a pixel.
  CHECK(bend(rows, 1, 0) == Approx(0.05 / 6).epsilon(1e-3));
  // At the ends of the row one neighbour is enough.
  CHECK(bend(rows, 0, 0) == Approx(0.05 / 6).epsilon(0.02));
  CHECK(bend(row_of(y, 1), 0, 0) == 0.0f);
}

TEST_CASE("a border that turns a corner or changes its bend is taken for straight", "[antialias]") {
  CHECK(bend(row_of([](double x) { return 0.3 + 0.1 * std::pow(x - 1.5, 3); }, 3), 1, 0) == 0.0f);
  CHECK(bend(row_of([](double x) { return 0.3 + 0.2 * std::max(0.0, x - 2.0); }, 3), 1, 0) == 0.0f);
}

TEST_CASE("borders of a row are found by column, replaced and taken away", "[antialias]") {
  BorderRow row;
  row.set(7, Border{.left = glm::vec4(1.0f)});
  row.set(3, Border{});
  row.set(7, Border{.left = glm::vec4(2.0f)});
  CHECK(row.columns() == std::vector{3, 7});
  CHECK(row.find(7)->left == glm::vec4(2.0f));
  row.set(3, std::nullopt);
  row.set(5, std::nullopt);
  CHECK(row.find(3) == nullptr);
  CHECK(row.columns() == std::vector{7});
}

}  // namespace
}  // namespace raycat
