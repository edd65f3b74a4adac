#pragma once

#include <cmath>

namespace raycat {

/// Linear light from an sRGB-encoded value, both 0 to 1 (IEC 61966-2-1).
inline float linear_from_srgb(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

/// The inverse.
inline float srgb_from_linear(float light) {
  return light <= 0.0031308f ? light * 12.92f : 1.055f * std::pow(light, 1.0f / 2.4f) - 0.055f;
}

}  // namespace raycat
