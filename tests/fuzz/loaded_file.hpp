#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace raycat {

/// Loads `bytes` as a scene file of that name, in a temporary folder without other files, and
/// traces a few rays through it. That it cannot be read is no failure; anything but a `LoadError`
/// of one line is.
void load_bytes(std::span<const std::uint8_t> bytes, const std::filesystem::path& name);

}  // namespace raycat
