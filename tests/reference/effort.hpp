#pragma once

namespace raycat::reference {

/// By how much less is compared in builds for finding errors, in which the reference takes many
/// times as long.
#ifdef NDEBUG
inline constexpr unsigned sparing = 1;
#else
inline constexpr unsigned sparing = 6;
#endif

}  // namespace raycat::reference
