#pragma once

#include <cstddef>
#include <string_view>

namespace dupin::text {

/// How many bytes at the start of `text` are a UTF-8 byte order mark, which some editors write: 3
/// or none. Who looks at a text's first bytes looks behind it.
[[nodiscard]] constexpr std::size_t byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.starts_with(kMark) ? kMark.size() : 0;
}

}  // namespace dupin::text
