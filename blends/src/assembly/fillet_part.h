#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "assembly/parts/pipe_starts.h"
#include "dupin/blends/part_surface.h"
#include "dupin/blends/resolve.h"

namespace dupin::assembly {

/// What a document says of two pipes beside their outer surfaces.
struct PipeWalls {
  std::array<double, 2> walls{};    ///< 0 of a pipe without a bore
  std::array<double, 2> outward{};  ///< by how much the outer radius is more than what it says
  PipeStarts starts;
};

/// The fillet of a ball of this radius between two straight pipes or cones of circular sections:
/// which of the ways round their crossing lie on both, and which ends the other one buries.
///
/// Throws Error{infeasible_blend} that says why there is none and, where a smaller ball would do,
/// the largest radius that would (`largest_radius_below`), if any with a fillet of the bore, too;
/// Error{invalid_argument} for other surfaces. Pipes' radii are said as the document has them.
[[nodiscard]] Fillet fillet_between(const std::array<const PartSurface*, 2>& pipes,
                                    const std::array<std::string, 2>& names, double radius,
                                    const PipeWalls& walls = {});

/// The same, but all that takes time is left to `find_loops` and then `prove`: only which ends it
/// buries is known.
[[nodiscard]] Fillet fillet_without_loops(const std::array<const PartSurface*, 2>& pipes,
                                          const std::array<std::string, 2>& names, double radius,
                                          const PipeWalls& walls = {});

/// Where the ball rolls. Throws as `fillet_between` does.
void find_loops(Fillet& fillet, const std::array<const PartSurface*, 2>& pipes,
                const std::array<std::string, 2>& names, const PipeWalls& walls);

/// That it does not fold: its `regularity`. Throws as `fillet_between` does.
void prove(Fillet& fillet, const std::array<const PartSurface*, 2>& pipes,
           const std::array<std::string, 2>& names, const PipeWalls& walls);

/// Why there is no such fillet; none where there is one. Throws for other surfaces as it does.
[[nodiscard]] std::optional<std::string> fillet_fault(
    const std::array<const PartSurface*, 2>& pipes, const std::array<std::string, 2>& names,
    double radius);

/// The largest radius that fits and is smaller than this one, which does not: it was found to fit,
/// and 1 % more not to, unless radii that fit have several gaps; of few digits. None if neither a
/// thousandth, a hundredth, a tenth nor half of it fits. Asks some 60 times at most.
[[nodiscard]] std::optional<double> largest_radius_below(double radius,
                                                         const std::function<bool(double)>& fits);

/// The curves in which they cross, and what they bury.
///
/// Throws Error{infeasible_blend} that says why there are none within their lengths, or why they do
/// not bound both faces; Error{invalid_argument} for other surfaces.
[[nodiscard]] Fillet cope_between(const std::array<const PartSurface*, 2>& pipes,
                                  const std::array<std::string, 2>& names,
                                  const PipeWalls& walls = {});

}  // namespace dupin::assembly
