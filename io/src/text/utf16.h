#pragma once

#include <string>
#include <string_view>

namespace dupin::text {

/// Whether a text is in UTF-16, as some editors save it: by its byte order mark, or as every other
/// one of its first bytes is zero, and no byte between them.
[[nodiscard]] bool is_utf16(std::string_view bytes);

/// Throws Error{parse_failed} for such a text, of which a reader would say that what it looks for
/// is missing. `file` is its name, for the message.
void refuse_utf16(std::string_view bytes, const std::string& file);

}  // namespace dupin::text
