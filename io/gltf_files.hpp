#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace raycat {

using Bytes = std::vector<std::uint8_t>;

// Everything that a scene file names is reached through these, which trust nothing. All throw
// `std::runtime_error` with the reason alone; the caller knows the place.

/// The content of a regular file of at most 4 GiB, which is all that a GLB can hold. Directories,
/// pipes and devices are refused before they are opened.
Bytes read_bytes(const std::filesystem::path& file);

/// The file that a relative `uri` names in `folder` or below, after percent-decoding. Refuses
/// schemes, absolute paths, backslashes, `..` and symbolic links that lead out.
std::filesystem::path resolve_uri(const std::filesystem::path& folder, std::string_view uri);

bool is_data_uri(std::string_view uri) noexcept;

/// The content of a `data:` URI, in base64 or percent-encoded.
Bytes decode_data_uri(std::string_view uri);

/// `text` on one line of at most 100 characters, for messages that quote a file.
std::string excerpt(std::string_view text);

}  // namespace raycat
