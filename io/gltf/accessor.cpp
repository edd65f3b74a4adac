#include "io/gltf/accessor.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "io/files/load_error.hpp"

namespace raycat {
namespace {

std::size_t component_size(int type) noexcept {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

// Columns of matrices start at multiples of four bytes.
std::size_t element_size(const tinygltf::Accessor& accessor) noexcept {
  const std::size_t size = component_size(accessor.componentType);
  const auto matrix = [size](std::size_t n) { return n * ((n * size + 3) / 4 * 4); };
  switch (accessor.type) {
    case TINYGLTF_TYPE_SCALAR:
      return size;
    case TINYGLTF_TYPE_VEC2:
      return 2 * size;
    case TINYGLTF_TYPE_VEC3:
      return 3 * size;
    case TINYGLTF_TYPE_VEC4:
      return 4 * size;
    case TINYGLTF_TYPE_MAT2:
      return matrix(2);
    case TINYGLTF_TYPE_MAT3:
      return matrix(3);
    default:
      return matrix(4);
  }
}

int component_count(const tinygltf::Accessor& accessor) noexcept {
  return accessor.type == TINYGLTF_TYPE_SCALAR ? 1
         : accessor.type <= TINYGLTF_TYPE_VEC4 ? accessor.type
                                               : 0;
}

template <class T>
T load(const std::uint8_t* bytes) noexcept {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

std::uint32_t load_index(const std::uint8_t* bytes, int type) noexcept {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return *bytes;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<std::uint16_t>(bytes);
    default:
      return load<std::uint32_t>(bytes);
  }
}

std::string accessor_place(std::size_t accessor) { return fmt::format("accessors[{}]", accessor); }

// Are `count` elements of `size` bytes, `stride` apart from `offset` on, within `length`?
bool fits(std::size_t offset, std::size_t count, std::size_t stride, std::size_t size,
          std::size_t length) noexcept {
  if (count == 0) {
    return true;
  }
  return size <= length && offset <= length - size &&
         (count - 1) <= (length - size - offset) / stride;
}

void check_views(const GltfDocument& document) {
  for (std::size_t i = 0; i < document.model.bufferViews.size(); ++i) {
    const auto& view = document.model.bufferViews[i];
    const std::size_t length =
        document.json["buffers"][static_cast<std::size_t>(view.buffer)]["byteLength"];
    if (view.byteLength > length || view.byteOffset > length - view.byteLength) {
      throw LoadError(document.file, fmt::format("bufferViews[{}]", i),
                      fmt::format("{} bytes from {} overrun the {} of buffers[{}]", view.byteLength,
                                  view.byteOffset, length, view.buffer));
    }
  }
}

}  // namespace

bool is_index_type(int component_type) noexcept {
  return component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
         component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

GltfAccessor::GltfAccessor(const GltfDocument& document, std::size_t number)
    : count_(document.model.accessors[number].count),
      component_size_(component_size(document.model.accessors[number].componentType)),
      components_(component_count(document.model.accessors[number])),
      component_type_(document.model.accessors[number].componentType),
      normalized_(document.model.accessors[number].normalized),
      matrices_(document.model.accessors[number].type == TINYGLTF_TYPE_MAT4 &&
                component_type_ == TINYGLTF_COMPONENT_TYPE_FLOAT) {
  const tinygltf::Accessor& accessor = document.model.accessors[number];
  const auto view_data = [&](int view) {
    const auto bytes = document.view_bytes(static_cast<std::size_t>(view));
    const auto& buffer_view = document.model.bufferViews[static_cast<std::size_t>(view)];
    if (bytes.empty() && buffer_view.byteLength > 0) {
      throw LoadError(document.file, accessor_place(number),
                      fmt::format("bufferViews[{}] is of buffers[{}], which has no data", view,
                                  buffer_view.buffer));
    }
    return bytes.data();
  };
  if (count_ == 0) {
    return;
  }
  const std::size_t size = element_size(accessor);
  stride_ = size;
  if (accessor.bufferView >= 0) {
    const auto stride =
        document.model.bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
    stride_ = stride > 0 ? stride : size;
    data_ = view_data(accessor.bufferView) + accessor.byteOffset;
    if (!accessor.sparse.isSparse) {
      return;
    }
  }
  auto patched = std::make_shared<Bytes>(count_ * size);
  for (std::size_t i = 0; data_ && i < count_; ++i) {
    std::memcpy(patched->data() + i * size, data_ + i * stride_, size);
  }
  if (accessor.sparse.isSparse) {
    const auto& sparse = accessor.sparse;
    const auto* indices = view_data(sparse.indices.bufferView) + sparse.indices.byteOffset;
    const auto* values = view_data(sparse.values.bufferView) + sparse.values.byteOffset;
    const std::size_t index_size = component_size(sparse.indices.componentType);
    for (std::size_t i = 0; i < static_cast<std::size_t>(sparse.count); ++i) {
      const std::size_t at = load_index(indices + i * index_size, sparse.indices.componentType);
      if (at >= count_) {
        throw LoadError(document.file, accessor_place(number),
                        fmt::format("sparse index {} is past the {} elements", at, count_));
      }
      std::memcpy(patched->data() + at * size, values + i * size, size);
    }
  }
  stride_ = size;
  data_ = patched->data();
  patched_ = std::move(patched);
}

double GltfAccessor::component(const std::uint8_t* bytes) const noexcept {
  const auto scaled = [this](double value, double most) {
    return normalized_ ? std::max(value / most, -1.0) : value;
  };
  switch (component_type_) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return scaled(load<std::int8_t>(bytes), 127.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return scaled(*bytes, 255.0);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return scaled(load<std::int16_t>(bytes), 32767.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return scaled(load<std::uint16_t>(bytes), 65535.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return scaled(load<std::uint32_t>(bytes), 4294967295.0);
    default:
      return static_cast<double>(load<float>(bytes));
  }
}

glm::dvec4 GltfAccessor::operator[](std::size_t i) const noexcept {
  glm::dvec4 element(0.0);
  const std::uint8_t* bytes = data_ + i * stride_;
  for (int c = 0; c < components_; ++c) {
    element[c] = component(bytes + static_cast<std::size_t>(c) * component_size_);
  }
  return element;
}

glm::dmat4 GltfAccessor::matrix(std::size_t i) const noexcept {
  glm::dmat4 matrix(0.0);
  const std::uint8_t* bytes = data_ + i * stride_;
  for (int c = 0; c < 16; ++c) {
    matrix[c / 4][c % 4] = component(bytes + static_cast<std::size_t>(c) * component_size_);
  }
  return matrix;
}

std::uint32_t GltfAccessor::index(std::size_t i) const noexcept {
  return load_index(data_ + i * stride_, component_type_);
}

void check_accessors(const GltfDocument& document, LoadBudget& budget) {
  check_views(document);
  for (std::size_t i = 0; i < document.model.accessors.size(); ++i) {
    const tinygltf::Accessor& accessor = document.model.accessors[i];
    const auto fail = [&](const std::string& what) {
      throw LoadError(document.file, accessor_place(i), what);
    };
    if (component_size(accessor.componentType) == 0) {
      fail(fmt::format("component type {} is not one of glTF 2.0", accessor.componentType));
    }
    const std::size_t size = element_size(accessor);
    const auto require = [&](int view, std::size_t offset, std::size_t count, std::size_t element,
                             bool strided) {
      const auto& of = document.model.bufferViews[static_cast<std::size_t>(view)];
      const std::size_t stride = strided && of.byteStride > 0 ? of.byteStride : element;
      if (stride < element) {
        fail(fmt::format("elements of {} bytes are {} bytes apart in bufferViews[{}]", element,
                         stride, view));
      }
      if (!fits(offset, count, stride, element, of.byteLength)) {
        fail(fmt::format("{} elements of {} bytes from byte {} overrun the {} of bufferViews[{}]",
                         count, element, offset, of.byteLength, view));
      }
    };
    if (accessor.bufferView >= 0) {
      require(accessor.bufferView, accessor.byteOffset, accessor.count, size, true);
    }
    // Without a view it is zeros, which cost nothing in the file; where it is sparse, a copy.
    if (accessor.bufferView < 0 || accessor.sparse.isSparse) {
      budget.take_memory(document.file, accessor_place(i), accessor.count, size);
    }
    if (!accessor.sparse.isSparse) {
      continue;
    }
    const auto& sparse = accessor.sparse;
    if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > accessor.count) {
      fail(fmt::format("sparse: replaces {} of {} elements", sparse.count, accessor.count));
    }
    if (!is_index_type(sparse.indices.componentType)) {
      fail(fmt::format("sparse: component type {} is not one of indices",
                       sparse.indices.componentType));
    }
    if (sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) {
      fail("sparse: a byte offset is past 2^31");
    }
    const auto count = static_cast<std::size_t>(sparse.count);
    require(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), count,
            component_size(sparse.indices.componentType), false);
    require(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), count,
            size, false);
  }
}

}  // namespace raycat
