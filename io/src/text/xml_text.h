#pragma once

#include <string>
#include <string_view>

#include "text/mesh_text.h"

namespace dupin::text {

/// One line of the text that XML can hold: U+FFFE and U+FFFF, which it has not, become U+FFFD.
[[nodiscard]] inline std::string xml_line(std::string_view text) {
  std::string line = clean_line(text);
  for (const std::string_view none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"}) {
    for (std::size_t at = 0; (at = line.find(none, at)) != std::string::npos;) {
      line.replace(at, none.size(), "\xEF\xBF\xBD");
    }
  }
  return line;
}

/// The same as XML has it between tags and in attributes.
[[nodiscard]] inline std::string xml_escaped(std::string_view text) {
  std::string safe;
  for (const char c : xml_line(text)) {
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
