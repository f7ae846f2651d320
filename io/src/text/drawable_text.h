#pragma once

#include <string>
#include <string_view>

#include "text/mesh_text.h"

namespace dupin::text {

/// One line of text as cairo takes it: Unicode's noncharacters (U+FDD0 to U+FDEF, and the last two
/// of each plane), which it refuses, become U+FFFD.
[[nodiscard]] inline std::string drawable(std::string_view text) {
  constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
  std::string line = clean_line(text);
  std::string safe;
  for (std::string_view rest = line; !rest.empty();) {
    const auto lead = static_cast<unsigned char>(rest.front());
    const std::size_t size = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    unsigned code = lead & (size == 1 ? 0x7FU : 0xFFU >> (size + 1));
    for (std::size_t i = 1; i < size; ++i) {
      code = code << 6U | (static_cast<unsigned char>(rest[i]) & 0x3FU);
    }
    const bool is_character = (code & 0xFFFEU) != 0xFFFEU && !(code >= 0xFDD0 && code <= 0xFDEF);
    safe += is_character ? rest.substr(0, size) : kReplacement;
    rest.remove_prefix(size);
  }
  return safe;
}

}  // namespace dupin::text
