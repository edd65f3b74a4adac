#include "io/input_file.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include "io/scene_file.hpp"

namespace raycat {

void require_regular_file(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw LoadError(file, "", "no such file");
  }
  if (error) {
    throw LoadError(file, "", error.message());
  }
  if (std::filesystem::is_directory(status)) {
    throw LoadError(file, "", "is a directory, not a scene file");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw LoadError(file, "", "is not a regular file");
  }
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) {
    throw LoadError(file, "", error.message());
  }
  if (size == 0) {
    throw LoadError(file, "", "is empty");
  }
}

std::string read_input_file(const std::filesystem::path& file, std::uintmax_t most_bytes) {
  require_regular_file(file);
  const std::uintmax_t size = std::filesystem::file_size(file);
  if (size > most_bytes) {
    throw LoadError(file, "",
                    fmt::format("files hold at most {} bytes, but this has {}", most_bytes, size));
  }
  std::ifstream in(file, std::ios::binary);
  std::string bytes(size, '\0');
  if (!in.read(bytes.data(), static_cast<std::streamsize>(size))) {
    throw LoadError(file, "", "cannot be read");
  }
  return bytes;
}

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return extension;
}

}  // namespace raycat
