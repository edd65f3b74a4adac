#include "threads/parallel.hpp"

#include <algorithm>
#include <random>
#include <stdexcept>
#include <utility>

#include <catch2/catch.hpp>

#include "geometry/disjoint_sets.hpp"

namespace raycat {
namespace {

TEST_CASE("every row is worked on once, whatever the threads", "[geometry][parallel]") {
  const int threads = GENERATE(1, 2, 7);
  std::vector<int> times(1000);
  std::atomic<bool> known = true;
  parallel_rows(1000, threads, [&](int row, int worker) {
    ++times[static_cast<std::size_t>(row)];
    known = known && worker >= 0 && worker < threads;
  });
  CHECK(times == std::vector<int>(1000, 1));
  CHECK(known);
}

TEST_CASE("what a row throws on one of two threads comes out, and stops the rest",
          "[geometry][parallel]") {
  std::atomic<int> rows = 0;
  const auto work = [&](int row, int) {
    ++rows;
    if (row == 3) {
      throw std::runtime_error("row 3");
    }
  };
  CHECK_THROWS_WITH(parallel_rows(1'000'000, 2, work), "row 3");
  CHECK(rows < 1'000'000);
}

TEST_CASE("no rows are no work for any thread", "[geometry][parallel]") {
  parallel_rows(0, 4, [](int, int) { FAIL(); });
}

TEST_CASE("parts are all numbers in order, and no more than threads or work",
          "[geometry][parallel]") {
  const std::size_t size = GENERATE(0u, 1u, 40'000u, 1'000'003u);
  const int threads = GENERATE(0, 1, 2, 7);
  const int parts = part_count(size, threads);
  CHECK(parts >= 1);
  CHECK(parts <= std::max(threads, 1));
  std::vector<std::pair<std::size_t, std::size_t>> ranges(static_cast<std::size_t>(parts));
  parallel_parts(size, threads, [&](std::size_t begin, std::size_t end, int part) {
    ranges[static_cast<std::size_t>(part)] = {begin, end};
  });
  CHECK(ranges.front().first == 0);
  CHECK(ranges.back().second == size);
  for (std::size_t i = 1; i < ranges.size(); ++i) {
    CHECK(ranges[i].first == ranges[i - 1].second);
  }
}

TEST_CASE("sets joined on several threads are those joined on one", "[geometry][parallel]") {
  constexpr std::uint32_t size = 200'000;
  std::mt19937 random(5);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs(size / 2);
  for (auto& [a, b] : pairs) {
    a = static_cast<std::uint32_t>(random() % size);
    b = static_cast<std::uint32_t>(random() % size);
  }
  const auto firsts = [&](int threads) {
    DisjointSets sets(size);
    parallel_parts(pairs.size(), threads, [&](std::size_t begin, std::size_t end, int) {
      for (std::size_t i = begin; i < end; ++i) {
        sets.join(pairs[i].first, pairs[i].second);
      }
    });
    std::vector<std::uint32_t> out(size);
    for (std::uint32_t i = 0; i < size; ++i) {
      out[i] = sets.first(i);
    }
    return out;
  };
  const std::vector<std::uint32_t> alone = firsts(1);
  for (std::uint32_t i = 0; i < size; ++i) {
    REQUIRE(alone[i] <= i);
    REQUIRE(alone[alone[i]] == alone[i]);
  }
  for (const auto& [a, b] : pairs) {
    REQUIRE(alone[a] == alone[b]);
  }
  CHECK(firsts(2) == alone);
  CHECK(firsts(6) == alone);
}

}  // namespace
}  // namespace raycat
