#pragma once

#include <cstdint>
#include <vector>

#include "dupin/blends/resolve.h"

namespace dupin::assembly {

/// Parts welded to each other along shared rings, in the order of a walk along them.
struct WeldedRun {
  std::vector<std::uint32_t> parts;
};

/// Every part in exactly one run; runs ordered by their first part in document order. A run that
/// is not a closed loop is walked from its end with the smaller first part.
[[nodiscard]] std::vector<WeldedRun> welded_runs(const ResolvedAssembly& assembly);

/// The spacing of the lattice that mesh points lie on: a power of two, at most 1/2048 of the
/// tolerance and of the smallest radius and straight length. Throws Error{invalid_argument} if the
/// coordinates do not fit doubles on such a lattice.
[[nodiscard]] double lattice_spacing(const Assembly& assembly, const ResolvedAssembly& resolved);

}  // namespace dupin::assembly
