#include "render/edge_class_palette.hpp"

#include <fmt/format.h>

namespace raycat {
namespace {

// Of the palette that Okabe and Ito made for all kinds of colour vision, but for the first.
constexpr std::array<std::array<std::uint8_t, 3>, all_edge_classes.size()> colours{{
    {30, 30, 30},
    {0, 114, 178},
    {86, 180, 233},
    {230, 159, 0},
    {204, 121, 167},
    {0, 158, 115},
}};

}  // namespace

std::array<std::array<std::uint8_t, 3>, 64> edge_class_palette() {
  std::array<std::array<std::uint8_t, 3>, 64> palette{};
  palette[0] = {255, 255, 255};
  for (std::size_t mask = 1; mask < palette.size(); ++mask) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      unsigned sum = 0;
      unsigned classes = 0;
      for (std::size_t i = 0; i < colours.size(); ++i) {
        if ((mask >> i & 1u) != 0) {
          sum += colours[i][channel];
          ++classes;
        }
      }
      palette[mask][channel] = static_cast<std::uint8_t>((2 * sum + classes) / (2 * classes));
    }
  }
  return palette;
}

std::string edge_class_legend() {
  std::string legend;
  for (const EdgeClass edge_class : all_edge_classes) {
    legend +=
        fmt::format("{}{} {}", legend.empty() ? "" : ", ", int{bit(edge_class)}, name(edge_class));
  }
  return legend;
}

}  // namespace raycat
