#pragma once

#include <cstddef>
#include <string_view>

namespace dupin {

/// The two ends of a piece, a chain or a part.
enum class End { start, end };

/// "start" or "end".
[[nodiscard]] constexpr std::string_view name(End end) {
  return end == End::start ? "start" : "end";
}

[[nodiscard]] constexpr End opposite(End end) { return end == End::start ? End::end : End::start; }

/// Its position in an array of both.
[[nodiscard]] constexpr std::size_t at(End end) { return end == End::start ? 0 : 1; }

}  // namespace dupin
