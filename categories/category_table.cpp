#include "categories/category_table.hpp"

#include <algorithm>
#include <stdexcept>

namespace raycat {

std::uint64_t hash_words(std::span<const std::uint32_t> words) noexcept {
  std::uint64_t hash = 0x9e3779b97f4a7c15 ^ words.size();
  for (const std::uint32_t word : words) {
    hash = (hash ^ word) * 0xff51afd7ed558ccd;
    hash ^= hash >> 32;
  }
  return hash;
}

void CategoryTable::grow() {
  slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), free);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t id = 0; id < hashes_.size(); ++id) {
    std::size_t slot = hashes_[id] & mask;
    while (slots_[slot] != free) {
      slot = (slot + 1) & mask;
    }
    slots_[slot] = static_cast<std::uint32_t>(id);
  }
}

CategoryId CategoryTable::intern(std::span<const std::uint32_t> words) {
  if (2 * (size() + 1) > slots_.size()) {
    grow();
  }
  const std::uint64_t hash = hash_words(words);
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash & mask;
  for (; slots_[slot] != free; slot = (slot + 1) & mask) {
    const CategoryId id{slots_[slot]};
    if (hashes_[slots_[slot]] == hash && std::ranges::equal(this->words(id), words)) {
      return id;
    }
  }
  if (size() == free) {
    throw std::length_error("an image holds at most 4294967295 distinct categories");
  }
  slots_[slot] = static_cast<std::uint32_t>(size());
  words_.insert(words_.end(), words.begin(), words.end());
  ends_.push_back(words_.size());
  hashes_.push_back(hash);
  return CategoryId{slots_[slot]};
}

std::span<const std::uint32_t> CategoryTable::words(CategoryId id) const {
  const auto i = static_cast<std::size_t>(id);
  const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
  return std::span(words_).subspan(begin, ends_[i] - begin);
}

std::size_t CategoryTable::bytes() const noexcept {
  return words_.capacity() * sizeof(words_[0]) + ends_.capacity() * sizeof(ends_[0]) +
         hashes_.capacity() * sizeof(hashes_[0]) + slots_.capacity() * sizeof(slots_[0]);
}

}  // namespace raycat
