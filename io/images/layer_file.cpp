#include "io/images/layer_file.hpp"

#include <cstddef>
#include <stdexcept>

#include <fmt/format.h>

#include "io/files/input_file.hpp"
#include "io/files/output_file.hpp"
#include "io/images/exr_file.hpp"

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
  std::vector<ExrChannel> channels;
  for (const Layer& layer : layers) {
    channels.push_back(
        {.name = layer.name,
         .whole = std::holds_alternative<std::vector<std::uint32_t>>(layer.values),
         .first = std::visit([](const auto& values) -> const void* { return values.data(); },
                             layer.values)});
  }
  std::vector<std::byte> file;
  try {
    file = exr_file(width, height, channels, provenance);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", path.string(), error.what()));
  }
  write_file(path, file);
}

}  // namespace raycat
