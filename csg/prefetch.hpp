#pragma once

namespace raycat {

/// Begins to bring what `place` points at into the cache, so that by the time it is read other work
/// has been done instead of waiting. Changes nothing else; any address will do.
inline void prefetch(const void* place) noexcept {
#if defined(__GNUC__)
  __builtin_prefetch(place);
#else
  static_cast<void>(place);
#endif
}

}  // namespace raycat
