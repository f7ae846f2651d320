#pragma once

#include <vector>

#include "dupin/blends/ringed_surface.h"

namespace dupin {

/// A point that a pipe's spine goes through, and the pipe's radius there.
struct Waypoint {
  Vec3 point = Vec3::Zero();
  double radius = 1;
};

/// A solid in the way: all points within `radius` of a parallelepiped with this corner and up to
/// three edges from it. A ball has none, a capsule one, a box three; of a triangle, two edges are
/// given.
struct Obstacle {
  Vec3 corner;
  std::vector<Vec3> edges;
  double radius = 0;
  bool is_triangle = false;
};

struct SplinePipeOptions {
  double margin = 0.05;  ///< least acceptable min(1 - kappa R) of every piece, in [0, 1)
};

/// A pipe from port to port through way-points: one cyclic piece [MS06] per span on the C2 cubic
/// spline with chord-length knots, clamped to the ports' axes, with the radius law R1.
///
/// Neighbouring pieces share their ring bitwise and their tangent planes all around, because R' is
/// zero and the curvature vectors agree there; the first and last go on tangentially from the
/// ports, as cyclic_blend does. Without way-points there is one piece.
///
/// Throws Error{irregular_surface} naming the span and the parameter interval where the margin is
/// missed, Error{invalid_argument} for bad numbers, ports of cones, and neighbouring points that
/// coincide.
[[nodiscard]] std::vector<RingedSurface> spline_pipe(const Ring& from,
                                                     const std::vector<Waypoint>& through,
                                                     const Ring& to,
                                                     const SplinePipeOptions& options = {});

/// A closed pipe through at least 3 way-points on the periodic spline; piece i runs from point i
/// to its successor, and the last one's end ring is the first one's start. Throws as spline_pipe.
[[nodiscard]] std::vector<RingedSurface> closed_spline_pipe(const std::vector<Waypoint>& through,
                                                            const SplinePipeOptions& options = {});

}  // namespace dupin
