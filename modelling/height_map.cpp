#include "modelling/height_map.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include <glm/geometric.hpp>

#include "modelling/triangulation.hpp"

namespace raycat {
namespace {

class HeightMap {
 public:
  HeightMap(const std::vector<std::vector<double>>& rows, std::uint32_t columns, bool centred)
      : columns_(columns), rows_(static_cast<std::uint32_t>(rows.size())) {
    if (centred) {
      origin_ = -0.5 * glm::dvec2(columns_ - 1, rows_ - 1);
    }
    double lowest = 1.0;  // OpenSCAD's first guess
    for (std::uint32_t y = 0; y < rows_; ++y) {
      for (std::uint32_t x = 0; x < columns_; ++x) {
        const double height = x < rows[y].size() ? rows[y][x] : 0.0;
        lowest = std::min(lowest, height);
        mesh_.positions.emplace_back(origin_ + glm::dvec2(x, y), height);
      }
    }
    base_ = lowest - 1.0;
    mesh_.face_count = 6;
  }

  TriangleMesh build() {
    add_surface();
    add_border();
    return std::move(mesh_);
  }

 private:
  std::uint32_t corner(std::uint32_t x, std::uint32_t y) const { return y * columns_ + x; }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t face) {
    mesh_.triangles.emplace_back(a, b, c);
    mesh_.faces.push_back(face);
  }

  void add_surface() {
    for (std::uint32_t y = 0; y + 1 < rows_; ++y) {
      for (std::uint32_t x = 0; x + 1 < columns_; ++x) {
        const std::uint32_t around[4] = {corner(x, y), corner(x + 1, y), corner(x + 1, y + 1),
                                         corner(x, y + 1)};
        glm::dvec3 middle(0.0);
        for (const std::uint32_t i : around) {
          middle += 0.25 * mesh_.positions[i];
        }
        const auto centre = static_cast<std::uint32_t>(mesh_.positions.size());
        mesh_.positions.push_back(middle);
        for (int k = 0; k < 4; ++k) {
          add(around[k], around[(k + 1) % 4], centre, 0);
        }
      }
    }
  }

  // The corners of the rim, counter-clockwise from above, and the face of the wall after each.
  void add_border() {
    std::vector<std::uint32_t> rim;
    std::vector<std::uint32_t> face;
    const auto add_rim = [&](std::uint32_t x, std::uint32_t y, std::uint32_t wall) {
      rim.push_back(corner(x, y));
      face.push_back(wall);
    };
    for (std::uint32_t x = 0; x + 1 < columns_; ++x) {
      add_rim(x, 0, 2);
    }
    for (std::uint32_t y = 0; y + 1 < rows_; ++y) {
      add_rim(columns_ - 1, y, 3);
    }
    for (std::uint32_t x = columns_ - 1; x > 0; --x) {
      add_rim(x, rows_ - 1, 4);
    }
    for (std::uint32_t y = rows_ - 1; y > 0; --y) {
      add_rim(0, y, 5);
    }
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto count = static_cast<std::uint32_t>(rim.size());
    Contour contour;
    for (const std::uint32_t i : rim) {
      contour.emplace_back(mesh_.positions[i]);
      mesh_.positions.emplace_back(contour.back(), base_);
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t next = (i + 1) % count;
      add(first + i, first + next, rim[next], face[i]);
      add(first + i, rim[next], rim[i], face[i]);
    }
    for (const glm::uvec3& t : triangulated({{contour}}).triangles) {
      add(first + t.z, first + t.y, first + t.x, 1);
    }
  }

  std::uint32_t columns_;
  std::uint32_t rows_;
  glm::dvec2 origin_{0.0};
  double base_ = 0.0;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh height_map(const std::vector<std::vector<double>>& rows, bool centred) {
  constexpr std::size_t most = 100'000'000;
  std::size_t columns = 0;
  for (const std::vector<double>& row : rows) {
    columns = std::max(columns, row.size());
  }
  if (rows.size() < 2 || columns < 2) {
    return {};
  }
  if (columns > most / rows.size()) {
    throw std::length_error("a height map has more than 100 million heights");
  }
  return HeightMap(rows, static_cast<std::uint32_t>(columns), centred).build();
}

double pixel_height(const glm::dvec3& colour, bool invert) {
  const double grey = glm::dot(colour, glm::dvec3(0.2126, 0.7152, 0.0722));
  return 100.0 / 255.0 * (invert ? 1.0 - grey : grey);
}

}  // namespace raycat
