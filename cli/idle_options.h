#pragma once

#include "build_arguments.h"
#include "output.h"
#include "rounding_options.h"

namespace dupin::cli {

/// Throws UsageError for options of `build` that would do nothing beside its output: who gives them
/// expects something of them. Of several processes or tiles, see check_tiled.
void refuse_idle_options(const BuildArguments& arguments);

/// Throws UsageError for what says how a surface is rounded and read back, where tetrahedra are
/// written.
void refuse_idle_of_volume(const RoundingArguments& rounding, const OutputArguments& output);

}  // namespace dupin::cli
