#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace raycat {

/// Writes a file whole or not at all: beside its place under another name, then renamed into
/// it. What is there but is no regular file, such as a device, is written to directly. Throws
/// `std::runtime_error` with the path and the system's reason.
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Throws as `write_file` would, for what can be known before: a folder that is not there or
/// takes no files, or a place that is itself a folder.
void require_writable(const std::filesystem::path& path);

/// Writes text.
void write_file(const std::filesystem::path& path, const std::string& text);

}  // namespace raycat
