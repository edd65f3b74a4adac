#include "io/gltf/meshopt.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <meshoptimizer.h>

#include "io/files/excerpt.hpp"
#include "io/files/load_error.hpp"

namespace raycat {
namespace {

/// What the extension says of one buffer view.
struct Compressed {
  std::span<const std::uint8_t> bytes;
  std::size_t count = 0;
  std::size_t stride = 0;
  std::string mode;
  std::string filter;
};

// The decoders trust these: they are told of them by assertions alone.
void check(const Compressed& from) {
  const auto require = [](bool met, const std::string& what) {
    if (!met) {
      throw std::runtime_error(what);
    }
  };
  const std::size_t stride = from.stride;
  if (from.mode == "ATTRIBUTES") {
    require(stride > 0 && stride <= 256 && stride % 4 == 0,
            fmt::format("byteStride: attributes are 4 to 256 bytes in fours, not {}", stride));
  } else if (from.mode == "TRIANGLES" || from.mode == "INDICES") {
    require(stride == 2 || stride == 4,
            fmt::format("byteStride: indices are 2 or 4 bytes, not {}", stride));
    require(from.mode == "INDICES" || from.count % 3 == 0,
            fmt::format("count: {} indices are no whole number of triangles", from.count));
    require(from.filter == "NONE", "filter: is only for attributes");
  } else {
    require(false,
            fmt::format("mode: '{}' is not ATTRIBUTES, TRIANGLES or INDICES", excerpt(from.mode)));
  }
  if (from.filter == "OCTAHEDRAL") {
    require(stride == 4 || stride == 8, "filter: OCTAHEDRAL needs a byteStride of 4 or 8");
  } else if (from.filter == "QUATERNION") {
    require(stride == 8, "filter: QUATERNION needs a byteStride of 8");
  } else {
    require(from.filter == "EXPONENTIAL" || from.filter == "NONE",
            fmt::format("filter: '{}' is not supported", excerpt(from.filter)));
  }
}

Bytes decoded(const Compressed& from) {
  Bytes bytes(from.count * from.stride);
  const auto* data = from.bytes.data();
  const std::size_t size = from.bytes.size();
  const int failed =
      from.mode == "ATTRIBUTES"
          ? meshopt_decodeVertexBuffer(bytes.data(), from.count, from.stride, data, size)
      : from.mode == "TRIANGLES"
          ? meshopt_decodeIndexBuffer(bytes.data(), from.count, from.stride, data, size)
          : meshopt_decodeIndexSequence(bytes.data(), from.count, from.stride, data, size);
  if (failed != 0) {
    throw std::runtime_error("the compressed data is broken");
  }
  if (from.filter == "OCTAHEDRAL") {
    meshopt_decodeFilterOct(bytes.data(), from.count, from.stride);
  } else if (from.filter == "QUATERNION") {
    meshopt_decodeFilterQuat(bytes.data(), from.count, from.stride);
  } else if (from.filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(bytes.data(), from.count, from.stride);
  }
  return bytes;
}

Compressed read(const GltfDocument& document, JsonFields& fields, const std::string& place) {
  const auto number = [&](const char* key) {
    const auto value = fields.whole(key);
    if (!value) {
      fields.fail(fmt::format("{}: is missing", key));
    }
    return *value;
  };
  const std::size_t buffer = number("buffer");
  Compressed from{.bytes = document.slice(buffer, fields.whole("byteOffset").value_or(0),
                                          number("byteLength"), place),
                  .count = number("count"),
                  .stride = number("byteStride"),
                  .mode = fields.string("mode").value_or(""),
                  .filter = fields.string("filter").value_or("NONE")};
  return from;
}

// Is there data in the buffer that a decoder which knows no meshopt would read?
bool has_fallback(const GltfDocument& document, const nlohmann::json& view) {
  const std::size_t buffer = view.at("buffer");
  return !document.buffers[buffer].empty();
}

}  // namespace

void decode_meshopt(GltfDocument& document, LoadBudget& budget) {
  const std::size_t views =
      document.json.contains("bufferViews") ? document.json["bufferViews"].size() : 0;
  for (std::size_t i = 0; i < views; ++i) {
    nlohmann::json& view = document.json["bufferViews"][i];
    const std::string place = fmt::format("bufferViews[{}]", i);
    auto fields = document.extension(view, "EXT_meshopt_compression", place);
    if (!fields) {
      fields = document.extension(view, "KHR_meshopt_compression", place);
    }
    if (!fields) {
      continue;
    }
    try {
      const Compressed from = read(document, *fields, place);
      check(from);
      budget.take_memory(document.file, place, from.count, from.stride);
      const std::size_t length = from.count * from.stride;
      const std::size_t buffer = document.add_buffer(decoded(from));
      view["buffer"] = buffer;
      view["byteOffset"] = 0;
      view["byteLength"] = length;
    } catch (const std::runtime_error& error) {
      if (has_fallback(document, view)) {
        document.warnings.push_back(
            fmt::format("{}: meshopt: {}; uncompressed data is read", place, error.what()));
        continue;
      }
      if (dynamic_cast<const LoadError*>(&error) != nullptr) {
        throw;
      }
      throw LoadError(document.file, place, fmt::format("meshopt: {}", error.what()));
    }
  }
}

}  // namespace raycat
