#include "geometry/parallel.hpp"

#include <stdexcept>

#include <catch2/catch.hpp>

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

TEST_CASE("what a row throws comes out, and stops the rest", "[geometry][parallel]") {
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

TEST_CASE("no rows are no work", "[geometry][parallel]") {
  parallel_rows(0, 4, [](int, int) { FAIL(); });
}

}  // namespace
}  // namespace raycat
