#pragma once

#include <cstddef>
#include <numbers>
#include <vector>

#include "dupin/kernel/progress.h"
#include "dupin/kernel/vec.h"

namespace dupin {

/// Whether this build makes such meshes. Needs packages of CGAL under the GPL, so it is an option
/// of the build (DUPIN_MESHING); without, `remesh` and `fill` throw Error{invalid_argument}.
[[nodiscard]] bool has_mesh_generator();

/// What a mesh for a solver has to be like. Lengths are in model units, angles in radians.
struct RemeshOptions {
  /// Largest distance from any point of either surface to the other; positive.
  double distance = 0;
  /// Edges are at most so long; 0 stands for a tenth of the diagonal of the box around the solid.
  double largest_edge = 0;
  /// Of triangles, as far as sharp edges allow; at most 30 degrees.
  double smallest_angle = 25 * std::numbers::pi / 180;
  /// Edges where the surface turns by more are sharp, and kept. So are borders between labels, and
  /// creases of coarse meshes that triangles of `largest_edge` would miss by far more than
  /// `distance`.
  double feature_angle = 40 * std::numbers::pi / 180;
  /// Of points; beyond, Error{limit_exceeded}.
  std::size_t most_points = 4'000'000;
  Progress progress;
};

/// A triangle with an angle below the bound.
struct PoorTriangle {
  Vec3 place = Vec3::Zero();  ///< its centroid
  double angle = 0;           ///< its smallest, in radians
  /// The angle is that of two sharp edges or borders, and cannot be larger.
  bool is_between_edges = false;
};

/// How well it went.
struct RemeshReport {
  /// A proved bound of the distance from every point of either surface to the other, region by
  /// region, beyond that of rounding to doubles; at most the one allowed.
  double deviation = 0;
  double smallest_angle = 0, shortest_edge = 0, longest_edge = 0;
  std::size_t poor_triangles = 0;      ///< below the angle that was asked for
  std::size_t poor_between_edges = 0;  ///< those of them that cannot have a larger one
  std::vector<PoorTriangle> worst;     ///< up to 10 of the others, then of these, the smallest
                                       ///< angles first
};

}  // namespace dupin
