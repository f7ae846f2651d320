#pragma once

#include "assembly/districts/district_plan.h"
#include "dupin/blends/build.h"

namespace dupin::assembly {

/// The solid of a district's parts, and what became of them: a Built without ports, gaps and
/// districts. The options' tolerance and segments are in its assembly already; where the whole
/// document has walls, or insulation, so has the assembly. Throws as `build` does.
[[nodiscard]] Built built_district(District district, const BuildOptions& options);

}  // namespace dupin::assembly
