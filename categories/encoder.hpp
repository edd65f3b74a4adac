#pragma once

#include <string_view>
#include <variant>

#include "categories/binary_heap.hpp"
#include "categories/category.hpp"

namespace raycat {

/// From a reduced ray tree to the words of its category.
using Encoder = std::variant<PackedHeap, WideHeap>;

/// The binary heap encoder for what `scene` needs: packed if it fits, else wide. Throws
/// `std::length_error` past the wide limits.
Encoder heap_encoder(const Extent& scene);

void encode(const Encoder& encoder, std::span<const RayNode> tree, CategoryWords& words);

}  // namespace raycat
