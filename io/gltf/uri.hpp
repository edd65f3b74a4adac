#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

#include "io/files/input_file.hpp"

namespace raycat {

/// All that a GLB can hold, and so the most of any file that belongs to a glTF scene.
inline constexpr std::uintmax_t max_gltf_bytes = std::uintmax_t{1} << 32;

// Everything that a glTF file names is reached through these, which trust nothing. All throw
// `std::runtime_error` with the reason alone; the caller knows the place.

/// The file that a relative `uri` names in `folder` or below, after percent-decoding. Refuses
/// schemes, absolute paths, backslashes, `..` and symbolic links that lead out.
std::filesystem::path resolve_uri(const std::filesystem::path& folder, std::string_view uri);

bool is_data_uri(std::string_view uri) noexcept;

/// The content of a `data:` URI, in base64 or percent-encoded.
Bytes decode_data_uri(std::string_view uri);

/// What `uri` stands for: the content of a `data:` URI, or of the file that a relative one names.
/// Tells `reserve` how many bytes that will be, before it makes room for them.
Bytes read_uri(const std::filesystem::path& folder, std::string_view uri,
               const std::function<void(std::uint64_t bytes)>& reserve);

}  // namespace raycat
