#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace dupin::text {

/// No document that is read here is deeper.
inline constexpr int kDeepestJson = 64;

/// The first bracket of JSON text that is nested deeper than kDeepestJson, if there is one: what
/// follows values level by level, as destroying them does, would need as deep a stack.
[[nodiscard]] std::optional<std::size_t> first_too_deep(std::string_view json);

/// Whether an object of JSON text, which is not too deep, has more than so many keys. Of text that
/// is malformed, whether it may have up to there.
[[nodiscard]] bool has_more_keys(std::string_view json, std::size_t most);

}  // namespace dupin::text
