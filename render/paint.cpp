#include "render/paint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tracer/srgb.hpp"

namespace raycat {
namespace {

const glm::vec3 black(0.0f);
const glm::vec3 white(1.0f);

Image two_coloured(const EdgeMap& edges, const glm::vec3& on, const glm::vec3& off) {
  Image image(edges.width, edges.height, off);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (edges.pixels[i] != 0) {
      image.pixels[i] = on;
    }
  }
  return image;
}

// Part `byte` of the hash, from 0 to 1.
float share_of(std::uint64_t hash, int byte) {
  return static_cast<float>(hash >> (8 * byte) & 0xff) / 255.0f;
}

// A hue anywhere, neither grey nor dark, so that neighbours stand apart from each other and from
// black lines. On the 8-bit sRGB grid, so that the picture's bytes are the colour itself.
glm::vec3 colour_of(std::uint64_t hash) {
  const float hue = 6.0f * share_of(hash, 1) + share_of(hash, 2) / 43.0f;
  const float saturation = 0.35f + 0.5f * share_of(hash, 3);
  const float value = 0.6f + 0.38f * share_of(hash, 4);
  glm::vec3 colour;
  for (int channel = 0; channel < 3; ++channel) {
    const float k = std::fmod(static_cast<float>(5 - 2 * channel) + hue, 6.0f);
    const float encoded =
        value - value * saturation * std::max(0.0f, std::min({k, 4.0f - k, 1.0f}));
    colour[channel] = linear_from_srgb(std::round(255.0f * encoded) / 255.0f);
  }
  return colour;
}

// Another hash for each `ordinal`, and for 0 the same.
std::uint64_t mixed(std::uint64_t hash, std::uint32_t ordinal) {
  if (ordinal == 0) {
    return hash;
  }
  const std::array<std::uint32_t, 3> words{static_cast<std::uint32_t>(hash >> 32),
                                           static_cast<std::uint32_t>(hash), ordinal};
  return hash_words(words);
}

}  // namespace

Image edge_image(const EdgeMap& edges) { return two_coloured(edges, white, black); }

Image line_image(const EdgeMap& edges) { return two_coloured(edges, black, white); }

Image overlay_image(const Image& picture, const EdgeMap& edges) {
  Image image(picture);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (edges.pixels[i] != 0) {
      image.pixels[i] = black;
    }
  }
  return image;
}

Image painted(const CategoryImage& categories, const std::vector<glm::vec3>& colours) {
  Image image(categories.width, categories.height);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      image.pixels[image.index(x, y)] = colours[static_cast<std::size_t>(categories.at(x, y))];
    }
  }
  return image;
}

Image segment_image(const CategoryImage& categories) {
  std::vector<glm::vec3> colours;
  for (std::size_t id = 0; id < categories.table.size(); ++id) {
    const auto words = categories.table.words(CategoryId{static_cast<std::uint32_t>(id)});
    colours.push_back(words.empty() ? white : colour_of(hash_words(words)));
  }
  return painted(categories, colours);
}

Image region_image(const CategoryImage& categories, const Regions& regions) {
  std::vector<std::uint32_t> seen(categories.table.size());  // regions of each category so far
  std::vector<glm::vec3> colours;
  colours.reserve(regions.count());
  for (const CategoryId category : regions.categories) {
    const auto words = categories.table.words(category);
    const std::uint32_t ordinal = seen[static_cast<std::size_t>(category)]++;
    const bool sky = words.empty() && ordinal == 0;
    colours.push_back(sky ? white : colour_of(mixed(hash_words(words), ordinal)));
  }
  Image image(regions.width, regions.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = colours[static_cast<std::size_t>(regions.labels[i])];
  }
  return image;
}

}  // namespace raycat
