#pragma once

namespace raycat {

/// Is this a sanitizer's build, in which exact arithmetic takes minutes where it takes seconds?
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace raycat
