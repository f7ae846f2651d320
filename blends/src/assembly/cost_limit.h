#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "assembly/welded_runs.h"
#include "dupin/kernel/districts.h"

namespace dupin::assembly {

/// Pairs of triangles side by side that may be compared, for each triangle allowed.
constexpr double kPairsPerTriangle = 10;

/// Throws Error{limit_exceeded} if the meshes of all parts together would have more than about
/// `most` triangles, or kPairsPerTriangle times as many pairs of them that lie side by side. The
/// error names the part that asks for most, and the tolerance that would do. Costs a few
/// evaluations per piece, whatever the meshes would.
void refuse_too_costly(const Assembly& assembly, const ResolvedAssembly& resolved,
                       std::span<const WeldedRun> runs, double grid, std::size_t most);

/// The same for each of several sets of parts, as outsides and bores are, where tolerances above
/// `coarsest` are none. The tolerance that would do does for all of them, and for those of `later`,
/// which is asked only then.
void refuse_too_costly(const Assembly& assembly,
                       const std::vector<const ResolvedAssembly*>& sets_of_parts, double grid,
                       std::size_t most, double coarsest,
                       const std::function<const ResolvedAssembly*()>& later);

/// How many triangles the meshes of all parts together will have, roughly; without those of fillets
/// if all others are more than enough. As quick. `given` has the sampling of each part, if it is
/// not to be found out.
[[nodiscard]] double expected_triangles(const Assembly& assembly, const ResolvedAssembly& resolved,
                                        std::span<const WeldedRun> runs, double grid,
                                        std::span<const RingSampling> given = {},
                                        double enough = std::numeric_limits<double>::infinity());

/// How many triangles the curves add in which parts of different runs cross, at most, roughly: of
/// all whose boxes touch, these and such along the parts' main axes, and that no fillet and no
/// junction joins, as if each went through the middle of the other. O(n log n) and these pairs.
[[nodiscard]] double expected_crossings(const Assembly& assembly, const ResolvedAssembly& resolved,
                                        const Boxes& boxes, std::span<const WeldedRun> runs,
                                        double grid, std::span<const RingSampling> given = {});

}  // namespace dupin::assembly
