#include "dupin/kernel/decimal.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace dupin {
namespace {

template <typename Number, typename... How>
void append(std::string& text, Number value, How... how) {
  std::array<char, 32> digits;  // the longest double, -1.2345678901234567e-308, takes 24
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value, how...);
  text.append(digits.data(), result.ptr);
}

double read(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
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

double rounded(double value, int digits) { return read(decimal(value, digits)); }

// A unit of the last digit is from 1e-6 to 1e-5 of the number.
std::string decimal_at_most(double value) {
  std::string text = decimal(value, kMessageDigits);
  for (double share = 6e-7; read(text) < value; share *= 2) {
    text = decimal(value + share * std::abs(value) + 1e-323, kMessageDigits);
  }
  return text;
}

std::string decimal_at_least(double value) {
  const std::string text = decimal_at_most(-value);
  return text.front() == '-' ? text.substr(1) : (read(text) == 0 ? "0" : "-" + text);
}

std::string decimal(const Vec3& point) {
  return "(" + decimal(point.x(), kPlaceDigits) + ", " + decimal(point.y(), kPlaceDigits) + ", " +
         decimal(point.z(), kPlaceDigits) + ")";
}

std::string byte_size(double bytes) {
  constexpr std::array<std::pair<double, const char*>, 4> kUnits{
      {{1e12, " TB"}, {1e9, " GB"}, {1e6, " MB"}, {1e3, " kB"}}};
  const double size = std::max(bytes, 1e3);
  const double digit = std::pow(10, std::floor(std::log10(size)) - 1);
  const double rounded = std::ceil(size / digit) * digit;
  const auto* const unit =
      std::ranges::find_if(kUnits, [&](const auto& each) { return rounded >= each.first; });
  return decimal(rounded / unit->first, 3) + unit->second;
}

void append_decimal(std::string& text, double value) { append(text, value); }
void append_decimal(std::string& text, float value) { append(text, value); }
void append_decimal(std::string& text, std::uint32_t value) { append(text, value); }

}  // namespace dupin
