#pragma once

#include <string>
#include <string_view>

#include "text/mesh_text.h"

namespace dupin::text {

/// One line of text as XML has it between tags and in attributes. U+FFFE and U+FFFF, which it has
/// not, become U+FFFD.
[[nodiscard]] inline std::string xml_escaped(std::string_view text) {
  std::string safe;
  const std::string line = clean_line(text);
  for (std::string_view rest = line; !rest.empty();) {
    if (rest.starts_with("\xEF\xBF\xBE") || rest.starts_with("\xEF\xBF\xBF")) {
      safe += "\xEF\xBF\xBD";
      rest.remove_prefix(3);
      continue;
    }
    const char c = rest.front();
    rest.remove_prefix(1);
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

}  // namespace dupin::text
