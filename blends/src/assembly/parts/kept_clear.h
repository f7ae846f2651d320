#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_kind.h"
#include "avoidance/obstacle.h"
#include "dupin/blends/part_shape.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {

/// What is listed under "avoid". Throws Error for numbers that are none, for the clearance too, and
/// for meshes that have no triangles, or hold one of the two points, where the way begins and ends.
[[nodiscard]] std::vector<avoidance::NamedObstacle> obstacles_of(const PartContext& context,
                                                                 const Avoidance& avoid,
                                                                 const std::array<Vec3, 2>& ends);

/// The parts that are to be avoided.
[[nodiscard]] std::vector<Need> needs_of(const std::optional<Avoidance>& avoid);

/// Error{infeasible_blend} with the tightest spot of a surface that is not proved to keep clear.
[[nodiscard]] std::optional<Error> nearness(const Chain& surface,
                                            const std::vector<avoidance::NamedObstacle>& obstacles,
                                            double clearance);

/// "a way of 3 pieces, proved to keep 5 from all that it avoids"; nothing of what avoids nothing.
[[nodiscard]] PartNotes clearance_note(const std::optional<Avoidance>& avoid,
                                       const PartSurface& surface);

}  // namespace dupin::assembly
