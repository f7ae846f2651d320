#pragma once

#include <string>
#include <string_view>

#include "text/mesh_text.h"

namespace dupin::text {

/// One line of text as XML has it between tags and in attributes.
[[nodiscard]] inline std::string xml_escaped(std::string_view text) {
  std::string safe;
  for (const char c : clean_line(text)) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
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
