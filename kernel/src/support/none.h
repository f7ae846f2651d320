#pragma once

#include <cstdint>

namespace dupin::support {

/// Stands for no index.
inline constexpr std::uint32_t kNone = 0xffffffff;

}  // namespace dupin::support
