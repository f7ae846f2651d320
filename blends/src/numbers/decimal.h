#pragma once

#include <array>
#include <charconv>
#include <string>

namespace dupin::numbers {

/// The shortest decimal that reads back as `x`, for messages.
[[nodiscard]] inline std::string decimal(double x) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x).ptr;
  return {text.data(), end};
}

/// `x` to a number of significant digits, for messages.
[[nodiscard]] inline std::string decimal(double x, int digits) {
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, digits)
          .ptr;
  return {text.data(), end};
}

}  // namespace dupin::numbers
