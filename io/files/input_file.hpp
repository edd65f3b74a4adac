#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace raycat {

using Bytes = std::vector<std::uint8_t>;

/// All bytes of a regular file of at most `most_bytes`, not empty. A directory, FIFO or device
/// would fail late or never end, and is refused before it is opened. Tells `reserve` how many bytes
/// there are, before it makes room for them. Throws `std::runtime_error` with the reason alone, for
/// callers that know the place.
Bytes read_bytes(
    const std::filesystem::path& file, std::uintmax_t most_bytes,
    const std::function<void(std::uint64_t bytes)>& reserve = [](std::uint64_t) {});

/// The same for a scene file. Throws `LoadError`.
std::string read_input_file(const std::filesystem::path& file, std::uintmax_t most_bytes);

/// Throws `LoadError` unless `file` is a regular file that is not empty.
void require_regular_file(const std::filesystem::path& file);

/// What the file's kind is told by: `.stl` for `A.STL`, empty if there is none.
std::string lower_extension(const std::filesystem::path& file);

}  // namespace raycat
