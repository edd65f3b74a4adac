#include "io/images/layer_file.hpp"

#include <cstring>
#include <stdexcept>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "io/files/input_file.hpp"
#include "io/files/output_file.hpp"
#include "io/images/attributes.hpp"

namespace raycat {

void require_layer_path(const std::filesystem::path& path) {
  if (lower_extension(path) != ".exr") {
    throw std::invalid_argument(
        fmt::format("{}: layers go to a file that ends in .exr", path.string()));
  }
}

void write_layers(const std::filesystem::path& path, int width, int height,
                  std::span<const Layer> layers, const Provenance& provenance) {
  require_layer_path(path);
  const auto output = OIIO::ImageOutput::create("openexr");
  if (!output) {
    throw std::runtime_error(fmt::format("{}: OpenImageIO cannot write openexr", path.string()));
  }
  OIIO::ImageSpec spec(width, height, static_cast<int>(layers.size()), OIIO::TypeDesc::FLOAT);
  spec.channelnames.clear();
  for (const Layer& layer : layers) {
    spec.channelnames.push_back(layer.name);
    spec.channelformats.emplace_back(std::holds_alternative<std::vector<float>>(layer.values)
                                         ? OIIO::TypeDesc::FLOAT
                                         : OIIO::TypeDesc::UINT32);
  }
  describe(provenance, true, spec);
  // All channels take four bytes.
  constexpr std::size_t size = 4;
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<unsigned char> data(size * layers.size() * pixels);
  for (std::size_t k = 0; k < layers.size(); ++k) {
    std::visit(
        [&](const auto& values) {
          for (std::size_t i = 0; i < pixels; ++i) {
            std::memcpy(data.data() + size * (i * layers.size() + k), &values[i], size);
          }
        },
        layers[k].values);
  }
  std::vector<unsigned char> file;
  OIIO::Filesystem::IOVecOutput memory(file);
  if (!output->set_ioproxy(&memory) || !output->open("image.exr", spec) ||
      !output->write_image(OIIO::TypeDesc::UNKNOWN, data.data()) || !output->close()) {
    throw std::runtime_error(fmt::format("{}: {}", path.string(), output->geterror()));
  }
  write_file(path, std::as_bytes(std::span(file)));
}

}  // namespace raycat
