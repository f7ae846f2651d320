#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace dupin {

// Text that people wrote, as one may print it.

/// How many bytes the control character has that the UTF-8 text begins with; 0 if it begins with
/// none. Those of ASCII, U+0080 to U+009F, the separators U+2028 and U+2029 of lines, and what
/// turns the direction of the text behind it, U+202A to U+202E and U+2066 to U+2069: what is
/// printed with them is not what is read.
[[nodiscard]] std::size_t control_length(std::string_view text);

/// Whether there is one in it.
[[nodiscard]] bool has_controls(std::string_view text);

/// The text with a backslash, an x and two digits for each byte of control characters, which
/// terminals obey and at which C strings end, but for those of ASCII in `kept`, and for bytes that
/// are no UTF-8. Valid UTF-8 on one line, then.
[[nodiscard]] std::string printable(std::string_view text, std::string_view kept = {});

}  // namespace dupin
