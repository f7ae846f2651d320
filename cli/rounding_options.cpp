#include "rounding_options.h"

#include <charconv>
#include <cmath>

#include <CLI/App.hpp>

#include "dupin/kernel/decimal.h"
#include "exit_code.h"
#include "length.h"

namespace dupin::cli {
namespace {

UsageError not_an_origin(const std::string& text) {
  return UsageError(
      "the origin must be keep, auto or three coordinates such as 1000,2000,0, not '" + text + "'");
}

Origin origin_of(const std::string& text) {
  if (text.empty() || text == "keep") {
    return {};
  }
  if (text == "auto") {
    return {.choice = Origin::Choice::automatic};
  }
  Origin origin{.choice = Origin::Choice::given};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (int k = 0; k < 3; ++k) {
    if (k > 0 && (at == end || *at++ != ',')) {
      throw not_an_origin(text);
    }
    const auto [stop, fault] = std::from_chars(at, end, origin.place[k]);
    if (fault != std::errc() || !std::isfinite(origin.place[k])) {
      throw not_an_origin(text);
    }
    at = stop;
  }
  if (at != end) {
    throw not_an_origin(text);
  }
  return origin;
}

double grid_of(const std::string& text, const std::string& unit) {
  const double grid = mesh_length(text, 0, unit);
  int exponent = 0;
  if (grid != 0 && std::frexp(grid, &exponent) != 0.5) {
    throw UsageError("the grid must be a power of two, such as " +
                     decimal(std::exp2(std::ilogb(grid))) + ", not '" + text + "'");
  }
  return grid;
}

}  // namespace

void add_rounding_options(CLI::App& command, RoundingArguments& arguments) {
  command
      .add_option("--origin", arguments.origin,
                  "What becomes (0, 0, 0) in the file: keep (default), auto for the\n"
                  "middle, or coordinates X,Y,Z")
      ->type_name("PLACE");
  command
      .add_option("--grid", arguments.grid,
                  "Round coordinates to multiples of this power of two, if the\nformat can")
      ->type_name("LENGTH");
  command
      .add_option("--rounding-tolerance", arguments.tolerance,
                  "Largest move of a point beyond rounding to the nearest number of the\nformat")
      ->type_name("LENGTH");
}

RoundingOptions rounding_options(const RoundingArguments& arguments, const std::string& unit) {
  return {mesh_length(arguments.tolerance, 0, unit), grid_of(arguments.grid, unit),
          origin_of(arguments.origin)};
}

}  // namespace dupin::cli
