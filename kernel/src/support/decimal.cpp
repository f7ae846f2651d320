#include "dupin/kernel/decimal.h"

#include <array>
#include <charconv>

namespace dupin {
namespace {

template <typename Number, typename... How>
void append(std::string& text, Number value, How... how) {
  std::array<char, 32> digits;  // the longest double, -1.2345678901234567e-308, takes 24
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value, how...);
  text.append(digits.data(), result.ptr);
}

}  // namespace

std::string decimal(double value) {
  std::string text;
  append(text, value);
  return text;
}

std::string decimal(double value, int digits) {
  std::string text;
  append(text, value, std::chars_format::general, digits);
  return text;
}

std::string decimal(const Vec3& point) {
  return "(" + decimal(point.x()) + ", " + decimal(point.y()) + ", " + decimal(point.z()) + ")";
}

void append_decimal(std::string& text, double value) { append(text, value); }
void append_decimal(std::string& text, float value) { append(text, value); }
void append_decimal(std::string& text, std::uint32_t value) { append(text, value); }

}  // namespace dupin
