#pragma once

#include <cstddef>
#include <string_view>

namespace dupin::numbers {

/// How many bytes the control character has that the UTF-8 text begins with; 0 if it begins with
/// none. Those of ASCII, U+0080 to U+009F, the separators U+2028 and U+2029 of lines, and what
/// turns the direction of the text behind it, U+202A to U+202E and U+2066 to U+2069: what is
/// printed with them is not what is read.
[[nodiscard]] constexpr std::size_t control_length(std::string_view text) {
  const auto is = [&](std::size_t at, unsigned from, unsigned to) {
    return at < text.size() && static_cast<unsigned char>(text[at]) >= from &&
           static_cast<unsigned char>(text[at]) <= to;
  };
  if (is(0, 0, 0x1F) || is(0, 0x7F, 0x7F)) {
    return 1;
  }
  if (is(0, 0xC2, 0xC2)) {
    return is(1, 0x80, 0x9F) ? 2 : 0;
  }
  const bool is_general = is(0, 0xE2, 0xE2) && ((is(1, 0x80, 0x80) && is(2, 0xA8, 0xAE)) ||
                                                (is(1, 0x81, 0x81) && is(2, 0xA6, 0xA9)));
  return is_general ? 3 : 0;
}

/// Whether there is one in it.
[[nodiscard]] constexpr bool has_controls(std::string_view text) {
  for (; !text.empty(); text.remove_prefix(1)) {
    if (control_length(text) > 0) {
      return true;
    }
  }
  return false;
}

}  // namespace dupin::numbers
