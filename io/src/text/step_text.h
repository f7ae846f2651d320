#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace dupin::text {

/// The code point of the well-formed UTF-8 sequence that `text` begins with, and its length; the
/// replacement character U+FFFD and 1 for other bytes.
struct CodePoint {
  std::uint32_t value = 0xFFFD;
  std::size_t length = 1;
};

inline CodePoint code_point(std::string_view text) {
  const auto byte = [&](std::size_t i) { return std::uint32_t(std::uint8_t(text[i])); };
  const std::uint32_t lead = byte(0);
  const std::size_t length = lead < 0x80   ? 1
                             : lead < 0xC2 ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
  if (length == 0 || text.size() < length) {
    return {};
  }
  std::uint32_t value = length == 1 ? lead : lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) {
      return {};
    }
    value = value << 6 | (byte(i) & 0x3FU);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = value >= 0xD800 && value < 0xE000;
  return value < kLeast[length] || is_surrogate || value > 0x10FFFF ? CodePoint{}
                                                                    : CodePoint{value, length};
}

/// A name as one line of visible characters: control characters and what is no UTF-8 become U+FFFD.
inline std::string printable(std::string_view name) {
  std::string result;
  while (!name.empty()) {
    const auto [value, length] = code_point(name);
    const bool is_control = value < 0x20 || (value >= 0x7F && value < 0xA0) || value == 0xFFFD;
    result += is_control ? std::string_view("\xEF\xBF\xBD") : name.substr(0, length);
    name.remove_prefix(length);
  }
  return result;
}

// ISO 10303-21 writes characters that are not ASCII as \X2\ and four hexadecimal digits, or, of
// those that need them, \X4\ and eight.
// What breaks lines in between knows nothing of that, nor of doubled quotes; so names take a
// detour.

/// The name as one line of printable ASCII without quotes and backslashes: these and all else are
/// "~" and four hexadecimal digits, or eight, "~".
inline std::string step_token(std::string_view name) {
  std::string result;
  for (std::string rest = printable(name); !rest.empty();) {
    const auto [value, length] = code_point(rest);
    if (value < 0x80 && value != '~' && value != '\'' && value != '\\') {
      result += char(value);
    } else {
      char digits[11];
      (void)std::snprintf(digits, sizeof digits, value < 0x10000 ? "~%04X~" : "~%08X~", value);
      result += digits;
    }
    rest.erase(0, length);
  }
  return result;
}

/// A file in which names are tokens, which may be broken by ends of lines, with the standard's
/// strings in their place.
inline std::string with_step_strings(std::string_view file) {
  std::string result, digits;
  result.reserve(file.size());
  bool is_token = false;
  for (const char c : file) {
    if (c == '~') {
      if (is_token) {
        result += (digits.size() == 8 ? "\\X4\\" : "\\X2\\") + digits + "\\X0\\";
      }
      digits.clear();
      is_token = !is_token;
    } else if (is_token) {
      digits += c == '\n' ? "" : std::string(1, c);
    } else {
      result += c;
    }
  }
  return result;
}

/// The same name in ASCII, for formats that know nothing else.
inline std::string ascii_only(std::string_view name) {
  std::string result;
  for (std::string rest = printable(name); !rest.empty();) {
    const auto [value, length] = code_point(rest);
    result += value < 0x80 ? char(value) : '_';
    rest.erase(0, length);
  }
  return result;
}

}  // namespace dupin::text
