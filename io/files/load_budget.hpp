#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "io/files/load_seconds.hpp"

namespace raycat {

/// Half of this machine's memory, in bytes.
std::uint64_t half_of_memory();

/// What reading a glTF file may take, so that a small file cannot ask for all of the machine.
struct LoadLimits {
  std::uint64_t memory = half_of_memory();           ///< bytes, for all that the file holds
  std::uint64_t pixels = std::uint64_t{1} << 26;     ///< of one image
  std::uint64_t nodes = std::uint64_t{1} << 24;      ///< of one file
  std::uint64_t instances = std::uint64_t{1} << 20;  ///< of meshes and placed assets
  std::uint64_t triangles = std::uint64_t{1} << 27;  ///< as drawn
};

/// What is left of the limits while a file, with those that it places, is read. Each `take` comes
/// before what it is for is allocated, and throws `LoadError`, which names the option that raises
/// the limit, if too little is left.
class LoadBudget {
 public:
  explicit LoadBudget(const LoadLimits& limits) : limits_(limits), left_(limits) {}

  const LoadLimits& limits() const noexcept { return limits_; }

  void take_memory(const std::filesystem::path& file, const std::string& place,
                   std::uint64_t bytes);

  /// `count` elements of `size` bytes, whose product may not be a number.
  void take_memory(const std::filesystem::path& file, const std::string& place, std::uint64_t count,
                   std::uint64_t size);
  void take_instances(const std::filesystem::path& file, const std::string& place,
                      std::uint64_t count);
  void take_triangles(const std::filesystem::path& file, const std::string& place,
                      std::uint64_t count);

  /// The time that has been taken so far, which has no limit.
  LoadSeconds& spent() noexcept { return spent_; }

  /// Of one file alone.
  void check_nodes(const std::filesystem::path& file, std::uint64_t count) const;

 private:
  LoadLimits limits_;
  LoadLimits left_;
  LoadSeconds spent_;
};

}  // namespace raycat
