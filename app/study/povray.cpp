#include "app/study/povray.hpp"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "io/files/other_program.hpp"
#include "io/povray/file.hpp"
#include "io/povray/program.hpp"

namespace raycat::app {
namespace {

// The means of blocks of `side` by `side` pixels of a PPM file of 16 bits a channel.
Pixels read_blocks(const std::filesystem::path& file, const ImageSize& size, int side) {
  std::ifstream in(file, std::ios::binary);
  std::string magic;
  int width = 0;
  int height = 0;
  int most = 0;
  in >> magic >> std::ws;
  while (in.peek() == '#') {
    in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  in >> width >> height >> most;
  in.get();
  if (magic != "P6" || width != size.width * side || height != size.height * side ||
      most != 65535) {
    throw std::runtime_error("povray: its picture is none of 16 bits and of the size asked for");
  }
  Pixels out(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  constexpr std::size_t pixel_size = 6;
  std::string line(pixel_size * static_cast<std::size_t>(width), '\0');
  const float share = 1.0f / static_cast<float>(side * side) / 65535.0f;
  for (int y = 0; y < height; ++y) {
    if (!in.read(line.data(), static_cast<std::streamsize>(line.size()))) {
      throw std::runtime_error("povray: its picture is cut short");
    }
    for (int x = 0; x < width; ++x) {
      glm::vec3& to =
          out[static_cast<std::size_t>(y / side) * static_cast<std::size_t>(size.width) +
              static_cast<std::size_t>(x / side)];
      for (int c = 0; c < 3; ++c) {
        const auto at = pixel_size * static_cast<std::size_t>(x) + 2 * static_cast<std::size_t>(c);
        const auto high = static_cast<unsigned char>(line[at]);
        const auto low = static_cast<unsigned char>(line[at + 1]);
        to[c] += share * static_cast<float>(256 * high + low);
      }
    }
  }
  return out;
}

}  // namespace

std::optional<PovScene::Picture> PovScene::render(const std::vector<std::string>& options) const {
  return render(1, options);
}

std::optional<Pixels> PovScene::reference(int side) const {
  auto picture = render(side, {"-A"});
  return picture ? std::optional(std::move(picture->colour)) : std::nullopt;
}

std::optional<PovScene::Picture> PovScene::render(int side,
                                                  const std::vector<std::string>& options) const {
  const ImageSize size{.width = size_.width * side, .height = size_.height * side};
  const ScratchFolder folder;
  const std::filesystem::path scene = folder / "scene.pov";
  const std::filesystem::path image = folder / "image.ppm";
  write_pov(scene, scene_,
            {.camera = camera_, .width = size.width, .height = size.height, .levels = levels_});
  std::vector<std::string> words{"+O" + image.string(),
                                 fmt::format("+W{}", size.width),
                                 fmt::format("+H{}", size.height),
                                 fmt::format("+WT{}", threads_),
                                 "+FP16",
                                 "File_Gamma=1",
                                 "-J"};
  words.insert(words.end(), options.begin(), options.end());
  const std::optional<PovrayRun> run = run_povray(scene, words);
  if (!run) {
    return std::nullopt;
  }
  return Picture{.colour = read_blocks(image, size_, side),
                 .per_pixel = run->rays / (static_cast<double>(size_.width) * size_.height),
                 .cpu = run->cpu};
}

}  // namespace raycat::app
