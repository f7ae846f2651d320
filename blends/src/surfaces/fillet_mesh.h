#pragma once

#include <array>
#include <vector>

#include "dupin/blends/canal_fillet.h"
#include "dupin/blends/tessellation.h"

namespace dupin::surfaces {

/// A loop of a fillet as triangles, and the closed polygons in which it meets its quadrics: their
/// corners are corners of the mesh, snapped, and have to be those of the trimmed quadrics.
struct FilletMesh {
  Tessellation tessellation;  ///< its knots are the parameters of the loop, in [0, 2 pi)
  std::uint32_t columns = 0;  ///< of triangles, along the feet
  std::array<std::vector<Vec3>, 2> feet;  ///< on the first and second quadric
};

/// How a loop is divided.
struct FilletSampling {
  double tolerance = 0.05;  ///< largest distance between the smooth surface and its mesh
  /// Largest angles about the quadrics' axes that neighbouring feet are apart, so that the faces
  /// beside them keep to the tolerance.
  std::array<double, 2> turns{0.1, 0.1};
  double grid = 0;  ///< as RingSampling::grid
  std::size_t most_triangles = kUsualTriangles;
};

/// Triangles counter-clockwise as seen from the balls. Rows go along the arcs between the feet;
/// where these coincide, as they do where equal pipes touch, a row is one point. Rows are placed by
/// bounds of second derivatives, as those of tubes are: `error_bound` is proved.
///
/// Throws Error{infeasible_blend} where that needs steps below rounding, and
/// Error{limit_exceeded} for too many triangles.
[[nodiscard]] FilletMesh fillet_mesh(const CanalFillet& loop, const FilletSampling& sampling);

/// What fillet_mesh() makes of a loop, about.
struct ExpectedFillet {
  double triangles = 0;                   ///< within a factor of 2 or 3
  std::array<std::vector<Vec3>, 2> feet;  ///< some, in their order, on both quadrics
};
/// Takes as long for any number of triangles.
[[nodiscard]] ExpectedFillet expected_fillet(const CanalFillet& loop,
                                             const FilletSampling& sampling);

}  // namespace dupin::surfaces
