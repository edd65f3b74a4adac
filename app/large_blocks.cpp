// Large blocks of memory lie on huge pages, where the system leaves that to programs. A mesh of a
// million triangles touches 200 MB for the first time, and on pages of 4 kB that takes longer than
// to read, weld and sort it (docs/benchmarks.md).

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>

#include <sys/mman.h>

namespace {

constexpr std::size_t huge_page = std::size_t{1} << 21;

// Whole pages, or else the rest of each block would be as slow as all of it was.
void* allocate(std::size_t size) noexcept {
  constexpr std::size_t large = huge_page / 2;
  if (size < large || size > std::numeric_limits<std::size_t>::max() - huge_page) {
    return std::malloc(size);
  }
  const std::size_t whole = (size + huge_page - 1) / huge_page * huge_page;
  void* block = nullptr;
  if (posix_memalign(&block, huge_page, whole) != 0) {
    return nullptr;
  }
  madvise(block, whole, MADV_HUGEPAGE);  // in vain, if it must be
  return block;
}

}  // namespace

void* operator new(std::size_t size) {
  for (;;) {
    if (void* block = allocate(size > 0 ? size : 1)) {
      return block;
    }
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) {
      throw std::bad_alloc();
    }
    handler();
  }
}

void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t /*size*/) noexcept { std::free(block); }
