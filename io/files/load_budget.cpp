#include "io/files/load_budget.hpp"

#include <limits>

#include <fmt/format.h>
#include <unistd.h>

#include "io/files/load_error.hpp"

namespace raycat {
namespace {

void take(const std::filesystem::path& file, const std::string& place, std::uint64_t count,
          std::uint64_t& left, std::uint64_t limit, const char* what, const char* option) {
  if (count > left) {
    throw LoadError(file, place,
                    fmt::format("needs {} {} where {} are left of the {} that {} allows", count,
                                what, left, limit, option));
  }
  left -= count;
}

}  // namespace

std::uint64_t half_of_memory() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long size = sysconf(_SC_PAGE_SIZE);
  constexpr std::uint64_t unknown = std::uint64_t{1} << 31;
  return pages > 0 && size > 0
             ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(size) / 2
             : unknown;
}

void LoadBudget::take_memory(const std::filesystem::path& file, const std::string& place,
                             std::uint64_t bytes) {
  take(file, place, bytes, left_.memory, limits_.memory, "bytes", "--max-memory");
}

void LoadBudget::take_memory(const std::filesystem::path& file, const std::string& place,
                             std::uint64_t count, std::uint64_t size) {
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  take_memory(file, place, count > most / size ? most : count * size);
}

void LoadBudget::take_instances(const std::filesystem::path& file, const std::string& place,
                                std::uint64_t count) {
  take(file, place, count, left_.instances, limits_.instances, "instances", "--max-instances");
}

void LoadBudget::take_triangles(const std::filesystem::path& file, const std::string& place,
                                std::uint64_t count) {
  take(file, place, count, left_.triangles, limits_.triangles, "triangles", "--max-triangles");
}

void LoadBudget::check_nodes(const std::filesystem::path& file, std::uint64_t count) const {
  std::uint64_t left = limits_.nodes;
  take(file, "nodes", count, left, limits_.nodes, "nodes", "--max-nodes");
}

}  // namespace raycat
