#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "io/gltf/document.hpp"

namespace raycat {

/// The elements of an accessor of scalars or vectors, of any component type, as numbers;
/// normalized integers as glTF 2.0 (3.11) maps them. Keeps a reference to the document.
class GltfAccessor {
 public:
  /// Throws `LoadError` if the buffer has no data, or a sparse index is out of range.
  GltfAccessor(const GltfDocument& document, std::size_t number);

  std::size_t size() const noexcept { return count_; }
  int components() const noexcept { return components_; }

  /// Element `i`; components it does not have are 0.
  glm::dvec4 operator[](std::size_t i) const noexcept;

  bool holds_matrices() const noexcept { return matrices_; }

  /// Element `i` of 4 x 4 matrices of floats.
  glm::dmat4 matrix(std::size_t i) const noexcept;

  /// Element `i` of integers.
  std::uint32_t index(std::size_t i) const noexcept;

 private:
  double component(const std::uint8_t* bytes) const noexcept;

  const std::uint8_t* data_ = nullptr;
  std::shared_ptr<const Bytes> patched_;  // the elements, where they are sparse
  std::size_t count_;
  std::size_t stride_ = 0;
  std::size_t component_size_;
  int components_;
  int component_type_;
  bool normalized_;
  bool matrices_;  // 4 x 4, of floats
};

/// Is a component type one that indices may have?
bool is_index_type(int component_type) noexcept;

/// Throws `LoadError` unless all of the document's buffer views lie within their buffers and its
/// accessors within their views. Everything that a `GltfAccessor` relies on. Takes from the budget
/// what accessors hold beside the buffers.
void check_accessors(const GltfDocument& document, LoadBudget& budget);

}  // namespace raycat
