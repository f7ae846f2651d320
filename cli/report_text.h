#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/io/report_json.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/stage_clock.h"

namespace dupin::cli {

/// A number for people: nine significant digits.
[[nodiscard]] std::string number(double value);

/// "at most 0.0123457 mm", which holds.
[[nodiscard]] std::string at_most(double bound, std::string_view unit);

/// "(1, 2, 3)".
[[nodiscard]] std::string place_text(const Vec3& place);

/// "1 point", "2 points".
[[nodiscard]] std::string counted(std::size_t count, std::string_view noun);

/// What stands for measures that were not taken, see is_measured().
constexpr const char* kUnknown = "not known: points are out of range";

/// "label               value" and a line break; the value is one line.
void print_row(std::ostream& out, std::string_view label, std::string_view value);

/// "exactly", or how far points are from where they were asked to be.
[[nodiscard]] std::string placement_text(bool is_exact, double largest_move, std::string_view unit);

/// Volume, if what is measured is closed, area, and whether it is. `unit` may be empty.
void print_sizes(std::ostream& out, const Report& report, std::string_view unit);

/// Counts, measures and findings of a mesh.
void print_report(std::ostream& out, const Report& report);

/// What was written, and how the rounding went. `unit` may be empty.
void print_output(std::ostream& out, const OutputReport& report, std::string_view unit);

/// One row per stage: seconds on the clock, and of all processors.
void print_timing(std::ostream& out, const std::vector<StageTime>& timing);

}  // namespace dupin::cli
