#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace raycat {

/// How a pixel is put together from what is around its middle. All are products of a function of x
/// and the same of y, which is 0 from the radius on: box 0.5 pixels, tent 1, gaussian 1.5
/// (standard deviation 0.5, less what it is at 1.5) and mitchell 2 (Mitchell & Netravali,
/// B = C = 1/3).
enum class Filter { box, tent, gaussian, mitchell };

/// The filter at `x` pixels from the middle; not normalized.
double weight(Filter filter, double x);

/// How many pixels to each side a filter takes something from.
int reach(Filter filter);

/// A picture of cells, `side` by `side` in a pixel, that are gathered into pixels: each cell counts
/// with the integral of the filter over it. What is outside the picture does not count.
class FilteredPicture {
 public:
  FilteredPicture(Filter filter, int width, int height, int side);

  /// The cells of a row of pixels: `side` rows of `width * side`. Once for each row; any number of
  /// threads may be at it, each at another row.
  void set_row(int row, std::span<const glm::vec4> cells);

  /// The pixels, once all rows of cells are there.
  void gather(int threads, std::vector<glm::vec4>& pixels) const;

 private:
  void gather_row(int row, std::span<glm::vec4> pixels) const;
  std::size_t place(int row, int below) const;

  int width_;
  int height_;
  int side_;
  int reach_;
  std::vector<float> weights_;      // of the cells from -reach_ pixels on, which sum to 1
  std::vector<float> of_pixel_;     // what those of one pixel sum to, from -reach_ on
  std::vector<glm::vec4> partial_;  // what each row gives to those from -reach_ above it on
};

}  // namespace raycat
