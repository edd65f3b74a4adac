#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace raycat {

/// A file that cannot be read as a scene. The message is one line: `FILE: place: what is wrong`.
class LoadError : public std::runtime_error {
 public:
  LoadError(const std::filesystem::path& file, const std::string& place, const std::string& what);
};

}  // namespace raycat
