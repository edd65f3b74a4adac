#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "categories/category.hpp"

namespace raycat {

/// A category of an image: comparing two pixels is comparing two integers.
enum class CategoryId : std::uint32_t {};

/// The distinct categories of an image, numbered from 0 in the order they are first met. Words
/// are compared whole; the hash only finds the place to look, so no two trees can be merged.
class CategoryTable {
 public:
  /// The number of the category with these words, which is new if they are. Throws
  /// `std::length_error` past 2^32 - 1 categories.
  CategoryId intern(std::span<const std::uint32_t> words);

  std::span<const std::uint32_t> words(CategoryId id) const;
  std::size_t size() const noexcept { return ends_.size(); }

  /// Memory held, the words and what finds them.
  std::size_t bytes() const noexcept;

 private:
  static constexpr std::uint32_t free = ~std::uint32_t{0};

  void grow();

  std::vector<std::uint32_t> words_;  // of all categories, one after the other
  std::vector<std::size_t> ends_;     // where each category's words end
  std::vector<std::uint64_t> hashes_;
  std::vector<std::uint32_t> slots_;  // open addressing; a power of two
};

/// A hash of a category's words that is the same on every machine.
std::uint64_t hash_words(std::span<const std::uint32_t> words) noexcept;

}  // namespace raycat
