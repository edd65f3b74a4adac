#include "io/gltf/container.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "io/files/load_error.hpp"
#include "io/gltf/uri.hpp"

namespace raycat {
namespace {

constexpr std::size_t max_depth = 256;
constexpr std::size_t max_json_bytes = std::size_t{1} << 30;

std::string byte_place(std::size_t byte) { return fmt::format("byte {}", byte); }

std::uint32_t u32(std::span<const std::uint8_t> bytes, std::size_t at) {
  return bytes[at] | std::uint32_t{bytes[at + 1]} << 8 | std::uint32_t{bytes[at + 2]} << 16 |
         std::uint32_t{bytes[at + 3]} << 24;
}

/// What can be told of a JSON text before it is parsed.
struct Outline {
  std::optional<std::size_t> too_deep_at;  // nlohmann parses without recursion, but copies with it
  std::uint64_t values = 0;                // at most so many
};

Outline outline(std::string_view text) {
  Outline found{.values = 1};
  std::size_t depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      i += c == '\\' ? 1 : 0;
      quoted = c != '"';
    } else if (c == '"') {
      quoted = true;
    } else if (c == '[' || c == '{') {
      ++found.values;
      if (++depth > max_depth) {
        found.too_deep_at = i;
        return found;
      }
    } else if ((c == ']' || c == '}') && depth > 0) {
      --depth;
    } else if (c == ',') {
      ++found.values;
    }
  }
  return found;
}

nlohmann::json parse_json(const std::filesystem::path& file, std::span<const std::uint8_t> bytes,
                          std::size_t offset, LoadBudget& budget) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.size() > max_json_bytes) {
    throw LoadError(
        file, byte_place(offset),
        fmt::format("JSON holds at most {} bytes, but this has {}", max_json_bytes, text.size()));
  }
  const Outline found = outline(text);
  if (found.too_deep_at) {
    throw LoadError(file, byte_place(offset + *found.too_deep_at),
                    fmt::format("JSON is nested more than {} deep", max_depth));
  }
  constexpr std::uint64_t bytes_a_value = 128;  // here, and in tinygltf's model
  budget.take_memory(file, "JSON", found.values, bytes_a_value);
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const std::size_t at = offset + std::max<std::size_t>(error.byte, 1) - 1;
    throw LoadError(file, byte_place(at), "not JSON");
  } catch (const nlohmann::json::out_of_range&) {
    throw LoadError(file, "JSON", "a number is too large");
  }
}

void open_glb(const std::filesystem::path& file, GltfContainer& container, LoadBudget& budget) {
  constexpr std::size_t header_size = 12;
  constexpr std::size_t chunk_header_size = 8;
  constexpr std::uint32_t json_chunk = 0x4e4f534a;
  constexpr std::uint32_t binary_chunk = 0x004e4942;

  std::span<const std::uint8_t> bytes = *container.bytes;
  if (bytes.size() < header_size + chunk_header_size) {
    throw LoadError(file, byte_place(bytes.size()), "the GLB header is cut short");
  }
  if (u32(bytes, 4) != 2) {
    throw LoadError(file, byte_place(4),
                    fmt::format("GLB version {} is not supported, only 2", u32(bytes, 4)));
  }
  const std::size_t length = u32(bytes, 8);
  if (length > bytes.size()) {
    throw LoadError(
        file, byte_place(8),
        fmt::format("the GLB header says {} bytes, but the file has {}", length, bytes.size()));
  }
  if (length < bytes.size()) {
    container.warnings.push_back(
        fmt::format("{} bytes after the end of the GLB are ignored", bytes.size() - length));
    bytes = bytes.first(length);
  }
  std::size_t chunk = 0;
  std::size_t at = header_size;
  for (; bytes.size() >= at + chunk_header_size; ++chunk) {
    const std::size_t size = u32(bytes, at);
    const std::uint32_t type = u32(bytes, at + 4);
    const std::size_t left = bytes.size() - at - chunk_header_size;
    if (size > left) {
      throw LoadError(
          file, byte_place(at),
          fmt::format("a GLB chunk of {} bytes overruns the {} that are left", size, left));
    }
    const auto content = bytes.subspan(at + chunk_header_size, size);
    if (chunk == 0) {
      if (type != json_chunk) {
        throw LoadError(file, byte_place(at + 4), "the first chunk of the GLB is not JSON");
      }
      container.json = parse_json(file, content, at + chunk_header_size, budget);
    } else if (chunk == 1 && type == binary_chunk) {
      container.binary = content;
      container.has_binary = true;
    } else {
      container.warnings.push_back(fmt::format("GLB chunk {} is ignored", chunk));
    }
    at += chunk_header_size + size;
  }
  if (chunk == 0) {
    throw LoadError(file, byte_place(at), "the GLB has no JSON chunk");
  }
}

}  // namespace

GltfContainer open_container(const std::filesystem::path& file, LoadBudget& budget) {
  GltfContainer container;
  try {
    container.bytes = std::make_shared<const Bytes>(read_bytes(
        file, max_gltf_bytes, [&](std::uint64_t size) { budget.take_memory(file, "", size); }));
  } catch (const LoadError&) {
    throw;
  } catch (const std::runtime_error& failure) {
    throw LoadError(file, "", failure.what());
  }
  constexpr std::string_view magic = "glTF";
  const bool binary = container.bytes->size() >= magic.size() &&
                      std::equal(magic.begin(), magic.end(), container.bytes->begin());
  if (binary) {
    open_glb(file, container, budget);
  } else {
    container.json = parse_json(file, *container.bytes, 0, budget);
    container.bytes.reset();
  }
  return container;
}

}  // namespace raycat
