#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace raycat {

/// Pixels of an image in linear light, from 0 to 1.
using Pixels = std::vector<glm::vec3>;

/// Peak signal to noise ratio in decibels, over all channels; both must have the same size, and
/// equal images 200 dB.
double psnr(const Pixels& image, const Pixels& reference);

/// The same after sRGB encoding, as displays are given it.
double psnr_encoded(const Pixels& image, const Pixels& reference);

/// The mean structural similarity of sRGB-encoded luma over all windows of 8 x 8 pixels (Wang,
/// Bovik, Sheikh, Simoncelli 2004, with a box for the window); 1 for equal images, and for those
/// smaller than a window.
double ssim(const Pixels& image, const Pixels& reference, int width);

/// How far pixels are from the reference, `gain` times, per channel.
Pixels difference_image(const Pixels& image, const Pixels& reference, float gain);

}  // namespace raycat
