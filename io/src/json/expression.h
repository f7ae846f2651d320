#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "dupin/blends/unit.h"
#include "json/json_document.h"

namespace dupin::json {

/// Expressions and texts with braces have at most so many bytes, and what they make too.
inline constexpr std::size_t kLongestExpression = 1000;

/// Why a name stands for nothing. Whoever reads the expression says where.
struct LookupFault {
  std::string message;
};

/// What a name stands for: a number, a text or a list of these. Throws LookupFault for one that is
/// unknown.
using Lookup = std::function<Json(std::string_view name)>;

/// Whether it can be the name of a value: letters, digits and _, no digit first, and no unit.
[[nodiscard]] bool is_value_name(std::string_view name);

/// Whether it begins with "=".
[[nodiscard]] bool is_expression(std::string_view text);

/// The value of "=run/2 + 3 mm": numbers, also with a unit, names, + - * / and parentheses. In
/// arithmetic a nominal size ("DN100") is its outside diameter; a lone name is whatever the name
/// stands for. All lengths are in `unit`, whole numbers unsigned. Throws what `node` fails with,
/// the message naming the column in bytes, for faults of form, names that stand for nothing, and
/// results that are not finite.
[[nodiscard]] Json evaluated(const JsonNode& node, Unit unit, const Lookup& lookup);

/// The text with the value of each {expression} in its place.
[[nodiscard]] std::string with_braces_replaced(const JsonNode& node, Unit unit,
                                               const Lookup& lookup);

/// "150 mm" in `unit`; none if it is not a number and a unit.
[[nodiscard]] std::optional<double> quantity(std::string_view text, Unit unit);

/// A double, or a whole number that keys which want one take.
[[nodiscard]] Json number_value(double value);

}  // namespace dupin::json
