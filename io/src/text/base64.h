#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dupin::text {

/// By RFC 4648, padded.
[[nodiscard]] std::string base64(std::string_view bytes);

/// The bytes again; none if `text` is not what `base64` gives.
[[nodiscard]] std::optional<std::string> from_base64(std::string_view text);

}  // namespace dupin::text
