#include "io/files/contained_path.hpp"

#include <algorithm>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "io/files/excerpt.hpp"

namespace raycat {

std::filesystem::path contained_path(const std::filesystem::path& folder, const std::string& path,
                                     std::string_view kind) {
  const auto refuse = [&](std::string_view why) {
    throw std::runtime_error(fmt::format("{} '{}' {}", kind, excerpt(path), why));
  };
  if (path.empty()) {
    refuse("is empty");
  }
  if (path.find('\0') != std::string::npos || path.find('\\') != std::string::npos) {
    refuse("holds a character that is not allowed");
  }
  const std::filesystem::path relative(path);
  if (relative.is_absolute() || std::ranges::find(relative, "..") != relative.end()) {
    refuse("leads out of the file's folder");
  }
  std::error_code error;
  const auto base = folder.empty() ? std::filesystem::path(".") : folder;
  const auto root = std::filesystem::canonical(base, error);
  const auto target = std::filesystem::weakly_canonical(base / relative, error);
  if (error || std::ranges::mismatch(root, target).in1 != root.end()) {
    refuse("leads out of the file's folder");
  }
  return base / relative;
}

}  // namespace raycat
