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

/// "(x, y, z)", of the shortest decimals.
[[nodiscard]] std::string decimal(const Vec3& point);

/// Appends the shortest decimal that reads back to `value`, a number of the same type.
void append_decimal(std::string& text, double value);
void append_decimal(std::string& text, float value);
void append_decimal(std::string& text, std::uint32_t value);

}  // namespace dupin
