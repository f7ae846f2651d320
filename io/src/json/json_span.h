#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace dupin::json {

/// A part of a text: [begin, end).
struct TextSpan {
  std::size_t begin = 0, end = 0;
};

using JsonStep = std::variant<std::string, std::size_t>;  ///< a key or an index

/// Where in `text`, which must be JSON, the value at the end of these steps stands, without the
/// white space around it. The steps must exist.
[[nodiscard]] TextSpan json_span(std::string_view text, const std::vector<JsonStep>& steps);

}  // namespace dupin::json
