#pragma once

#include <string>

#include "commands.h"
#include "dupin/kernel/rounding.h"

namespace dupin::cli {

/// --origin, --grid and --rounding-tolerance as typed; empty when not given.
struct RoundingArguments {
  std::string origin, grid, tolerance;
};

/// Adds them, shared by all commands that write a solid.
void add_rounding_options(CLI::App& command, RoundingArguments& arguments);

/// What they mean beside coordinates in `unit` (see mesh_length). Throws UsageError.
[[nodiscard]] RoundingOptions rounding_options(const RoundingArguments& arguments,
                                               const std::string& unit);

}  // namespace dupin::cli
