#pragma once

#include <string_view>
#include <variant>

#include "categories/binary_heap.hpp"
#include "categories/category.hpp"
#include "categories/godel_number.hpp"
#include "categories/id_string.hpp"
#include "categories/primes_product.hpp"

namespace raycat {

/// The four ways of Section 2.1 to describe a tree.
enum class Method { heap, string, primes, godel };

/// As the command line has it: heap, string, primes or godel.
std::string_view name(Method method);

/// From a reduced ray tree to the words of its category.
using Encoder = std::variant<PackedHeap, WideHeap, IdString, PrimesProduct, GodelNumber>;

/// The encoder of `method` for what `scene` needs; of the heaps the packed one if the scene fits
/// it, else the wide one. Throws `std::length_error` past the encoder's limits.
Encoder make_encoder(Method method, const Extent& scene);

void encode(const Encoder& encoder, std::span<const RayNode> tree, CategoryWords& words);

/// Does the category with these words not fit a machine word of 64 bits? Of the methods only
/// primes and godel make one number that can.
bool overflowed(const Encoder& encoder, std::span<const std::uint32_t> words);

/// Sets `tree` to the tree that a heap encoder wrote `words` of, all of it but the weights. The
/// other methods' words cannot be read back; for them it throws `std::logic_error`.
void decode(const Encoder& encoder, std::span<const std::uint32_t> words, RayTree& tree);

}  // namespace raycat
