#pragma once

namespace parent {
inline constexpr int own_header = 1;
}
