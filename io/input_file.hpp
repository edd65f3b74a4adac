#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace raycat {

/// Throws `LoadError` unless `file` is a regular file that is not empty: a directory, FIFO or
/// device would fail late or never end.
void require_regular_file(const std::filesystem::path& file);

/// All bytes of a regular file of at most `most_bytes`. Throws `LoadError` also when the file
/// cannot be opened or read.
std::string read_input_file(const std::filesystem::path& file, std::uintmax_t most_bytes);

/// What the file's kind is told by: `.stl` for `A.STL`, empty if there is none.
std::string lower_extension(const std::filesystem::path& file);

}  // namespace raycat
