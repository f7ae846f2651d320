#pragma once

#include <optional>
#include <vector>

#include "assembly/districts/district_plan.h"
#include "assembly/selected_parts.h"
#include "dupin/blends/build.h"
#include "dupin/blends/resolve.h"
#include "dupin/kernel/ring.h"

namespace dupin::assembly {

/// How far, by their places in Assembly::parts, the second surface of parts lies within the outer
/// one, or of insulation, which is around it; none where what is made has but one.
[[nodiscard]] std::optional<std::vector<double>> distances_between(const Assembly& assembly,
                                                                   const ResolvedAssembly& resolved,
                                                                   std::optional<Region> region);

/// Whether what is made of two parts that share this ring ends there in one disc or annulus: both
/// are as thick, and their second surfaces share a ring about the same centre in the same plane.
[[nodiscard]] bool ends_alike(const ResolvedAssembly& resolved, const EndIndex& end,
                              const std::optional<std::vector<double>>& distances,
                              std::optional<Region> region);

/// No coarser than a quarter of the thinnest wall.
[[nodiscard]] double tolerance_within_walls(double tolerance, const std::vector<double>& walls);

/// A lattice for both surfaces; the second one may have no parts.
[[nodiscard]] double lattice_of_both(const Assembly& assembly, const ResolvedAssembly& outer,
                                     const ResolvedAssembly& second);

/// The lattice of both, which leaves room where bores reach into gaps.
[[nodiscard]] double lattice_of_bores(const Assembly& assembly, const ResolvedAssembly& outer,
                                      const ResolvedAssembly& bore,
                                      const std::vector<double>& walls);

/// What pieces of a district have in common, for all its parts, without discs.
[[nodiscard]] PieceOf common_rings(const District& whole, std::optional<Region> region);

/// Those of parts, and of what goes on from them, which comes behind the parts.
[[nodiscard]] std::vector<RingSampling> with_what_goes_on(std::vector<RingSampling> samplings,
                                                          const ResolvedAssembly& parts);

}  // namespace dupin::assembly
