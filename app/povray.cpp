#include "app/povray.hpp"

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "io/other_program.hpp"
#include "io/pov_file.hpp"

namespace raycat::app {
namespace {

// From what POV-Ray prints:
//     Pixels:             4352   Samples:           16384   Smpls/Pxl: 3.76
//     Trace Time:       0 hours  0 minutes  0 seconds (0.221 seconds)
//                 using 1 thread(s) with 0.219 CPU-seconds total
// Pixels have one ray each, and samples are those beyond it.
void read_statistics(const std::filesystem::path& log, const ImageSize& size,
                     PovScene::Picture& picture) {
  std::ifstream in(log);
  bool tracing = false;
  for (std::string line; std::getline(in, line);) {
    double pixels = 0.0;
    double samples = 0.0;
    if (std::sscanf(line.c_str(), "Pixels: %lf Samples: %lf", &pixels, &samples) == 2) {
      picture.per_pixel = (pixels + samples) / (static_cast<double>(size.width) * size.height);
    }
    tracing = line.find("Time:") == std::string::npos
                  ? tracing
                  : line.find("Trace Time:") != std::string::npos;
    double cpu = 0.0;
    if (tracing &&
        std::sscanf(line.c_str(), " using %*d thread(s) with %lf CPU-seconds", &cpu) == 1) {
      picture.cpu = cpu;
    }
  }
}

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
  const std::filesystem::path log = folder / "log";
  write_pov(scene, scene_,
            {.camera = camera_, .width = size.width, .height = size.height, .levels = levels_});
  std::vector<std::string> words{"povray",
                                 "+I" + scene.string(),
                                 "+O" + image.string(),
                                 fmt::format("+W{}", size.width),
                                 fmt::format("+H{}", size.height),
                                 fmt::format("+WT{}", threads_),
                                 "+FP16",
                                 "File_Gamma=1",
                                 "-D",
                                 "-V",
                                 "-J"};
  words.insert(words.end(), options.begin(), options.end());
  const std::optional<int> status = run_program(words, log);
  if (!status) {
    return std::nullopt;
  }
  if (*status != 0) {
    throw std::runtime_error("povray: it failed on a scene as `convert` writes it");
  }
  Picture picture{.colour = read_blocks(image, size_, side)};
  read_statistics(log, size_, picture);
  return picture;
}

}  // namespace raycat::app
