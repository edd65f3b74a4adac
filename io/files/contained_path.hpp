#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace raycat {

/// The file that a scene file in `folder` names by a relative path, in that folder or below.
/// Refuses absolute paths, backslashes, `..` and symbolic links that lead out. Throws
/// `std::runtime_error` with the reason alone, for callers that know the place; `kind` says in it
/// what the path is.
std::filesystem::path contained_path(const std::filesystem::path& folder, const std::string& path,
                                     std::string_view kind);

}  // namespace raycat
