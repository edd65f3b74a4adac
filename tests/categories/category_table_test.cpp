#include "categories/category_table.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

namespace raycat {
namespace {

TEST_CASE("a category is numbered when first met and known ever after", "[categories][table]") {
  CategoryTable table;
  CHECK(table.intern(CategoryWords{1, 2}) == CategoryId{0});
  CHECK(table.intern(CategoryWords{}) == CategoryId{1});
  CHECK(table.intern(CategoryWords{2, 1}) == CategoryId{2});
  CHECK(table.intern(CategoryWords{1, 2}) == CategoryId{0});
  CHECK(table.size() == 3);
  CHECK(table.words(CategoryId{1}).empty());
  CHECK(table.words(CategoryId{2})[0] == 2);
}

TEST_CASE("two categories are one exactly when their words are equal", "[categories][table]") {
  CHECK(rc::check("against a map", [](const std::vector<std::vector<std::uint32_t>>& lists) {
    CategoryTable table;
    std::map<std::vector<std::uint32_t>, CategoryId> map;
    for (const auto& words : lists) {
      const auto expected =
          map.try_emplace(words, CategoryId{static_cast<std::uint32_t>(map.size())}).first->second;
      RC_ASSERT(table.intern(words) == expected);
    }
    RC_ASSERT(table.size() == map.size());
    for (const auto& [words, id] : map) {
      RC_ASSERT(std::ranges::equal(table.words(id), words));
    }
  }));
}

TEST_CASE("words are compared, not their hashes", "[categories][table]") {
  CategoryTable table;
  for (std::uint32_t i = 0; i < 200'000; ++i) {
    REQUIRE(table.intern(std::array{i, i * 0x9e3779b9u, 7u}) == CategoryId{i});
  }
  for (std::uint32_t i = 0; i < 200'000; ++i) {
    REQUIRE(table.intern(std::array{i, i * 0x9e3779b9u, 7u}) == CategoryId{i});
  }
}

TEST_CASE("the hash of a category is the same on every machine", "[categories][table]") {
  CHECK(hash_words(CategoryWords{}) == 0x9e3779b97f4a7c15);
  CHECK(hash_words(CategoryWords{0x01020003}) == 0xf578e3ddb7f211b6);
}

}  // namespace
}  // namespace raycat
