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

/// A STEP file (ISO 10303-21) whose strings hold UTF-8, with these characters written as the
/// standard asks for: \X2\ and four hexadecimal digits each (of UTF-16), \X0\ behind them.
inline std::string step_escaped(std::string_view file) {
  std::string result;
  result.reserve(file.size());
  bool is_open = false;
  while (!file.empty()) {
    const auto [value, length] = code_point(file);
    const bool is_plain = value < 0x80;
    if (is_open == is_plain) {
      result += is_plain ? "\\X0\\" : "\\X2\\";
      is_open = !is_plain;
    }
    const auto put = [&](std::uint32_t unit) {
      char digits[5];
      (void)std::snprintf(digits, sizeof digits, "%04X", unit);
      result += digits;
    };
    if (is_plain) {
      result += file.front();
    } else if (value < 0x10000) {
      put(value);
    } else {
      put(0xD800 + ((value - 0x10000) >> 10));
      put(0xDC00 + ((value - 0x10000) & 0x3FF));
    }
    file.remove_prefix(length);
  }
  return result;
}

}  // namespace dupin::text
