#include "io/files/input_file.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "io/files/load_error.hpp"

namespace raycat {

namespace {

std::uintmax_t regular_file_size(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw std::runtime_error("no such file");
  }
  if (error) {
    throw std::runtime_error(error.message());
  }
  if (std::filesystem::is_directory(status)) {
    throw std::runtime_error("is a directory, not a file");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw std::runtime_error("is not a regular file");
  }
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) {
    throw std::runtime_error(error.message());
  }
  if (size == 0) {
    throw std::runtime_error("is empty");
  }
  return size;
}

template <class Buffer>
Buffer read_whole(const std::filesystem::path& file, std::uintmax_t most_bytes,
                  const std::function<void(std::uint64_t bytes)>& reserve) {
  const std::uintmax_t size = regular_file_size(file);
  if (size > most_bytes) {
    throw std::runtime_error(
        fmt::format("files hold at most {} bytes, but this has {}", most_bytes, size));
  }
  reserve(size);
  std::ifstream in(file, std::ios::binary);
  Buffer bytes(size, typename Buffer::value_type{});
  if (!in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size))) {
    throw std::runtime_error("cannot be read");
  }
  return bytes;
}

}  // namespace

Bytes read_bytes(const std::filesystem::path& file, std::uintmax_t most_bytes,
                 const std::function<void(std::uint64_t bytes)>& reserve) {
  return read_whole<Bytes>(file, most_bytes, reserve);
}

std::string read_input_file(const std::filesystem::path& file, std::uintmax_t most_bytes) {
  try {
    return read_whole<std::string>(file, most_bytes, [](std::uint64_t) {});
  } catch (const std::runtime_error& error) {
    throw LoadError(file, "", error.what());
  }
}

void require_regular_file(const std::filesystem::path& file) {
  try {
    regular_file_size(file);
  } catch (const std::runtime_error& error) {
    throw LoadError(file, "", error.what());
  }
}

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return extension;
}

}  // namespace raycat
