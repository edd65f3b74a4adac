#include "antialias/filter.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "threads/parallel.hpp"

namespace raycat {

double weight(Filter filter, double x) {
  x = std::abs(x);
  switch (filter) {
    case Filter::box:
      return x <= 0.5 ? 1.0 : 0.0;
    case Filter::tent:
      return std::max(0.0, 1.0 - x);
    case Filter::gaussian: {
      const auto bell = [](double at) { return std::exp(-2.0 * at * at); };
      return std::max(0.0, bell(x) - bell(1.5));
    }
    case Filter::mitchell:
      break;
  }
  return x < 1.0   ? (7.0 * x - 12.0) * x * x + 16.0 / 3.0
         : x < 2.0 ? ((-7.0 / 3.0 * x + 12.0) * x - 20.0) * x + 32.0 / 3.0
                   : 0.0;
}

int reach(Filter filter) { return filter == Filter::box ? 0 : filter == Filter::mitchell ? 2 : 1; }

FilteredPicture::FilteredPicture(Filter filter, int width, int height, int side)
    : width_(width), height_(height), side_(side), reach_(reach(filter)) {
  const int cells = (2 * reach_ + 1) * side;
  std::vector<double> integrals(static_cast<std::size_t>(cells));
  for (int i = 0; i < cells; ++i) {
    constexpr int steps = 64;  // a cell, by the midpoint rule
    for (int step = 0; step < steps; ++step) {
      const double x = (i + (step + 0.5) / steps) / side - reach_ - 0.5;
      integrals[static_cast<std::size_t>(i)] += weight(filter, x);
    }
  }
  const double sum = std::accumulate(integrals.begin(), integrals.end(), 0.0);
  for (const double integral : integrals) {
    weights_.push_back(static_cast<float>(integral / sum));
  }
  for (auto pixel = weights_.begin(); pixel != weights_.end(); pixel += side) {
    of_pixel_.push_back(std::accumulate(pixel, pixel + side, 0.0f));
  }
  partial_.resize(place(height, 0));
}

std::size_t FilteredPicture::place(int row, int below) const {
  return static_cast<std::size_t>(row * (2 * reach_ + 1) + below) *
         static_cast<std::size_t>(width_);
}

void FilteredPicture::set_row(int row, std::span<const glm::vec4> cells) {
  std::vector<glm::vec4> filtered(static_cast<std::size_t>(width_));
  for (int j = 0; j < side_; ++j) {
    const auto line = cells.subspan(static_cast<std::size_t>(j) * filtered.size() *
                                    static_cast<std::size_t>(side_));
    for (int x = 0; x < width_; ++x) {
      const int first = std::max(x - reach_, 0) * side_;
      const int last = (std::min(x + reach_, width_ - 1) + 1) * side_;
      const int offset = (reach_ - x) * side_;
      glm::vec4 sum(0.0f);
      for (int i = first; i < last; ++i) {
        sum += weights_[static_cast<std::size_t>(i + offset)] * line[static_cast<std::size_t>(i)];
      }
      filtered[static_cast<std::size_t>(x)] = sum;
    }
    // A pixel `below - reach_` rows further down has this line that much further up.
    for (int below = 0; below <= 2 * reach_; ++below) {
      const float share = weights_[static_cast<std::size_t>((2 * reach_ - below) * side_ + j)];
      glm::vec4* to = &partial_[place(row, below)];
      for (const glm::vec4& from : filtered) {
        *to++ += share * from;
      }
    }
  }
}

void FilteredPicture::gather(int threads, std::vector<glm::vec4>& pixels) const {
  const auto width = static_cast<std::size_t>(width_);
  parallel_rows(height_, threads, [&](int row, int /*worker*/) {
    gather_row(row, std::span(pixels).subspan(static_cast<std::size_t>(row) * width, width));
  });
}

void FilteredPicture::gather_row(int row, std::span<glm::vec4> pixels) const {
  std::ranges::fill(pixels, glm::vec4(0.0f));
  const auto within = [this](int at, int size) {
    float sum = 0.0f;
    for (int offset = -reach_; offset <= reach_; ++offset) {
      const bool inside = at + offset >= 0 && at + offset < size;
      sum += inside ? of_pixel_[static_cast<std::size_t>(offset + reach_)] : 0.0f;
    }
    return sum;
  };
  for (int below = 0; below <= 2 * reach_; ++below) {
    const int from = row + reach_ - below;
    if (from >= 0 && from < height_) {
      const glm::vec4* partial = &partial_[place(from, below)];
      for (glm::vec4& pixel : pixels) {
        pixel += *partial++;
      }
    }
  }
  const float column = within(row, height_);
  for (int x = 0; x < width_; ++x) {
    pixels[static_cast<std::size_t>(x)] /= column * within(x, width_);
  }
}

}  // namespace raycat
