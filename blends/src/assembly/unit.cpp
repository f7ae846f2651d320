#include "dupin/blends/unit.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"

namespace dupin {
namespace {

struct UnitRow {
  Unit unit;
  std::string_view symbol;
  double tenths;  // of a millimetre: whole numbers, so that conversions round once or twice
};

constexpr std::array<UnitRow, 5> kUnits{{{Unit::millimetre, "mm", 10},
                                         {Unit::centimetre, "cm", 100},
                                         {Unit::metre, "m", 10000},
                                         {Unit::inch, "in", 254},
                                         {Unit::foot, "ft", 3048}}};

const UnitRow& row(Unit unit) { return kUnits.at(static_cast<std::size_t>(unit)); }

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

// Without its exponent, no product is beyond what fits. A length that is none any more is refused.
double converted(double value, Unit from, Unit to, std::string_view text) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  const double result = std::ldexp(mantissa * row(from).tenths / row(to).tenths, exponent);
  const std::string in_unit = quoted(text) + " in " + std::string(symbol(to));
  if (!std::isfinite(result)) {
    throw Error(Errc::invalid_argument, in_unit + " is more than " +
                                            decimal(std::numeric_limits<double>::max()) +
                                            ", the largest number");
  }
  if (result == 0) {
    throw Error(Errc::invalid_argument, in_unit + " is less than " +
                                            decimal(std::numeric_limits<double>::denorm_min()) +
                                            ", the smallest number");
  }
  return result;
}

}  // namespace

std::string_view symbol(Unit unit) { return row(unit).symbol; }

std::optional<Unit> unit_called(std::string_view symbol) {
  const auto* const found = std::ranges::find(kUnits, symbol, &UnitRow::symbol);
  return found == kUnits.end() ? std::nullopt : std::optional(found->unit);
}

Unit unit_from(std::string_view symbol) {
  if (const auto unit = unit_called(symbol)) {
    return *unit;
  }
  throw Error(Errc::invalid_argument,
              "the unit must be mm, cm, m, in or ft, not " + quoted(symbol));
}

double millimetres(Unit unit) { return row(unit).tenths / 10; }

double parse_length(std::string_view text, Unit unit) {
  const UsualArithmetic usual;
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, failure] = std::from_chars(text.data(), end, value);
  const std::string_view suffix(rest, static_cast<std::size_t>(end - rest));
  const bool is_unknown = !suffix.empty() && !unit_called(suffix);
  const bool is_no_number = is_unknown && (value == 0 || suffix.starts_with(','));  // 0,05
  if (failure != std::errc() || !std::isfinite(value) || is_no_number) {
    throw Error(Errc::invalid_argument,
                quoted(text) + " is not a length such as 0.05, 1mm or 0.5in");
  }
  if (value <= 0) {
    throw Error(Errc::invalid_argument, "a length must be positive, not " + quoted(text));
  }
  if (suffix.empty()) {
    return value;
  }
  return converted(value, unit_from(suffix), unit, text);
}

}  // namespace dupin
