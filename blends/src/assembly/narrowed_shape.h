#pragma once

#include <array>
#include <functional>

#include "dupin/blends/junction.h"
#include "dupin/blends/part_surface.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {

/// `radius - wall`. Throws Error{infeasible_blend} where that is not positive; so do the others.
[[nodiscard]] double less_wall(double radius, double wall);

/// A ring, a surface and two pipes less their walls, or more where a wall is negative.
[[nodiscard]] Ring narrowed(Ring ring, double wall);
[[nodiscard]] PartSurface narrowed(const PartSurface& surface, double wall);
[[nodiscard]] std::array<PartSurface, 2> narrowed(const std::array<const PartSurface*, 2>& pipes,
                                                  const std::array<double, 2>& walls);

/// The parallel junction inside, or outside; refused where that is none.
[[nodiscard]] Junction narrowed(Junction junction, double wall);

/// Of a cyclide's cone the ring of the parallel one, which is that moved along the axis.
[[nodiscard]] Ring parallel(Ring ring, double wall);

/// What is said of an insulation that is too thick: the largest that is not, to the digits of
/// messages, so that one more in the last of them is refused; or one that would do, where the
/// largest leaves no room for a mesh, as collars of junctions that have all but vanished do.
enum class InsulationAdvice { largest, some };

/// Throws an Error of the code of `folds`. `made` throws Error where a thickness is too large.
[[noreturn]] void refuse_insulation(double thickness, const Error& folds, InsulationAdvice advice,
                                    const std::function<void(double)>& made);

}  // namespace dupin::assembly
