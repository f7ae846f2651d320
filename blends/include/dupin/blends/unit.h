#pragma once

#include <optional>
#include <string_view>

namespace dupin {

/// The unit that all lengths of an assembly are in.
enum class Unit { millimetre, centimetre, metre, inch, foot };

/// "mm", "cm", "m", "in" or "ft".
[[nodiscard]] std::string_view symbol(Unit unit);

/// The unit with this symbol; none if there is none.
[[nodiscard]] std::optional<Unit> unit_called(std::string_view symbol);

/// The same. Throws Error{invalid_argument} naming the known ones.
[[nodiscard]] Unit unit_from(std::string_view symbol);

/// Millimetres in one unit; exact in decimal (an inch is 25.4 mm).
[[nodiscard]] double millimetres(Unit unit);

/// A positive length as people type it, "1mm", "0.5in" or "0.05" (then in `unit`), in `unit`.
/// Throws Error{invalid_argument} saying what is wrong with the text.
[[nodiscard]] double parse_length(std::string_view text, Unit unit);

}  // namespace dupin
