#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "meshing/edge_lengths.h"
#include "meshing/features.h"

namespace dupin::meshing {

/// A point of a curve, and the ball about it that no other point of a mesh comes into.
struct CurvePoint {
  Vec3 place = Vec3::Zero();
  double radius = 0;
  bool is_corner = false;  ///< an end of curves, other than of a loop that is alone there
  friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

/// Points that all regions' meshes have in common.
struct CurvePoints {
  std::vector<CurvePoint> points;
  std::vector<std::vector<std::uint32_t>> chains;  ///< per curve, from end to end
};

/// Points along curves so near each other that neighbours' balls overlap and, of curves that have a
/// region in common, no others do: triangulations of the regions then have the edges between
/// neighbours [Cheng, Dey and Ramos, Delaunay refinement for piecewise smooth complexes, 2007].
/// Lengths are those of `lengths` by `shares`, one for each curve, in (0, 1]. Throws
/// Error{limit_exceeded} naming the place where points get more than `most`.
[[nodiscard]] CurvePoints points_along(const Features& features, const EdgeLengths& lengths,
                                       const std::vector<double>& shares, std::size_t most);

}  // namespace dupin::meshing
