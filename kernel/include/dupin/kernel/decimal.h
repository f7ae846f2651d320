#pragma once

#include <cstdint>
#include <string>

#include "dupin/kernel/vec.h"

namespace dupin {

// Numbers as people and programs read them, the same in every locale.

/// The shortest decimal that reads back to the same double.
[[nodiscard]] std::string decimal(double value);

/// `value` to 1 to 17 significant digits, without zeros at the end.
[[nodiscard]] std::string decimal(double value, int digits);

/// The number that its text of so many digits reads back as.
[[nodiscard]] double rounded(double value, int digits);

/// Significant digits of numbers in messages, and of coordinates, which have to tell the place in a
/// plant: a hundredth of a millimetre at kilometres. What programs read has all digits.
constexpr int kMessageDigits = 6, kPlaceDigits = 9;

/// The number to kMessageDigits digits, rounded so that it is still a bound of `value`.
[[nodiscard]] std::string decimal_at_most(double value);
[[nodiscard]] std::string decimal_at_least(double value);

/// "(x, y, z)", each to kPlaceDigits digits.
[[nodiscard]] std::string decimal(const Vec3& point);

/// "860 kB", "1.3 GB": two digits, rounded up, as what it says has to do; at least 1 kB.
[[nodiscard]] std::string byte_size(double bytes);

/// Appends the shortest decimal that reads back to `value`, a number of the same type.
void append_decimal(std::string& text, double value);
void append_decimal(std::string& text, float value);
void append_decimal(std::string& text, std::uint32_t value);

}  // namespace dupin
