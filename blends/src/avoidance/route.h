#pragma once

#include <span>
#include <string>
#include <vector>

#include "avoidance/clearance.h"
#include "dupin/blends/spline_pipe.h"

namespace dupin::avoidance {

/// A pipe that keeps clear, proved.
struct Route {
  std::vector<RingedSurface> pipe;
  std::vector<Waypoint> through;
  double clearance = 0;  ///< a proved lower bound
};

/// The spline pipe from ring to ring, their normals pointing out of their parts, through `through`,
/// and through as many points more as it takes to keep at least `clearance` from all obstacles.
/// Points are added where the pipe comes nearest, off the obstacle in several directions, the most
/// promising way first; what is found is pulled tight. Their radii are between the neighbours'.
/// Where that fails, or the pipe folds without them, and no points are given, straight pipes and
/// elbows are tried (polyline.h), which have no such points. Deterministic.
///
/// Throws Error{infeasible_blend} with the tightest spot of the best way if none is found, and what
/// spline_pipe throws of the way that is given, if it is not regular and nothing else is found.
[[nodiscard]] Route route(const Ring& from, const std::vector<Waypoint>& through, const Ring& to,
                          std::span<const NamedObstacle> obstacles, double clearance);

}  // namespace dupin::avoidance
