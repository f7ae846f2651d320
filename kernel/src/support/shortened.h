#pragma once

#include <string>
#include <string_view>

namespace dupin::support {

/// What people typed can be of any length; a message shows so many bytes of it, at most.
constexpr std::size_t kShownBytes = 60;

/// The beginning of a text of more than kShownBytes, and an ellipsis.
[[nodiscard]] std::string shortened(std::string_view text);

/// A message, in which quoted texts, and words that are not paths, are shortened each.
[[nodiscard]] std::string with_short_quotes(std::string_view message);

/// A place, "FILE#/KEY/KEY", whose keys are shortened each; files have their names.
[[nodiscard]] std::string with_short_keys(std::string_view place);

}  // namespace dupin::support
