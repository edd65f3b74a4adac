#include "io/files/output_file.hpp"

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace raycat {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, int error) {
  throw std::runtime_error(
      fmt::format("{}: cannot write: {}", path.string(), std::generic_category().message(error)));
}

// An open file that is closed on the way out.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) {
      ::close(fd_);
    }
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool open() const { return fd_ >= 0; }
  int get() const { return fd_; }

  // Returns 0 or the error: some file systems report a full disk only here.
  int close() {
    const int result = ::close(fd_);
    fd_ = -1;
    return result == 0 ? 0 : errno;
  }

 private:
  int fd_;
};

int write_all(int fd, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(fd, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) {
      return errno;
    }
    if (count > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
  }
  return 0;
}

void write_through(const fs::path& path, std::span<const std::byte> bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!file.open()) {
    fail(path, errno);
  }
  if (const int error = write_all(file.get(), bytes); error != 0) {
    fail(path, error);
  }
  if (const int error = file.close(); error != 0) {
    fail(path, error);
  }
}

// The permissions that a newly made file has here.
mode_t usual_mode() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

void write_beside(const fs::path& path, std::span<const std::byte> bytes) {
  std::string name = path.string() + ".XXXXXX";
  Descriptor file(::mkostemp(name.data(), O_CLOEXEC));
  if (!file.open()) {
    fail(path, errno);
  }
  int error = write_all(file.get(), bytes);
  if (error == 0 && ::fchmod(file.get(), usual_mode()) != 0) {
    error = errno;
  }
  if (error == 0 && ::fsync(file.get()) != 0) {
    error = errno;
  }
  if (const int closing = file.close(); error == 0) {
    error = closing;
  }
  if (error == 0 && ::rename(name.c_str(), path.c_str()) != 0) {
    error = errno;
  }
  if (error != 0) {
    ::unlink(name.c_str());
    fail(path, error);
  }
}

}  // namespace

void write_file(const fs::path& path, std::span<const std::byte> bytes) {
  std::error_code ignored;
  const fs::path target = fs::is_symlink(path, ignored) ? fs::canonical(path, ignored) : path;
  const fs::file_status status = fs::status(target.empty() ? path : target, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    write_through(path, bytes);
  } else {
    write_beside(target.empty() ? path : target, bytes);
  }
}

void require_writable(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) {
    fail(path, EISDIR);
  }
  const bool device = fs::exists(status) && !fs::is_regular_file(status);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (::access(device ? path.c_str() : folder.c_str(), W_OK) != 0) {
    fail(path, errno);
  }
}

void write_file(const fs::path& path, const std::string& text) {
  write_file(path, std::as_bytes(std::span(text)));
}

}  // namespace raycat
