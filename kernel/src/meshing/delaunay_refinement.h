#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/progress.h"
#include "meshing/curve_points.h"
#include "meshing/features.h"
#include "meshing/tetrahedra.h"

namespace dupin::meshing {

/// A point of a region where its mesh begins.
struct Seed {
  Vec3 point = Vec3::Zero();
  std::uint32_t region = 0;
  bool is_needed = false;  ///< the region has no curve, which its mesh would begin at
};

/// What tetrahedra are to be like.
struct Refinement {
  std::function<double(const Vec3&)> edge_length;  ///< at most, along curves
  double radius = 0;          ///< largest circumradius of a triangle, and of a tetrahedron
  double distance = 0;        ///< from the middles of triangles to the surface
  double smallest_angle = 0;  ///< of triangles, in radians, away from curves
  bool fill = false;          ///< whether shapes and sizes of tetrahedra inside matter
  std::size_t most_points = 0;
  /// The generator has given up where it makes more: where edges that it may not cut keep it from a
  /// manifold, it would go on and on beside them.
  std::size_t most_useful_points = std::numeric_limits<std::size_t>::max();
  std::vector<Seed> seeds;
};

/// Delaunay tetrahedra of what a closed mesh bounds: those whose circumcentre is inside [BO05],
/// with balls along curves that protect them [Cheng, Dey and Ramos, Delaunay refinement for
/// piecewise smooth complexes, 2007]. By CGAL's Mesh_3, with exact predicates: tetrahedra do not
/// overlap. The same input gives the same tetrahedra, or none where the generator gives up on its
/// own. Throws Error{limit_exceeded} naming the place where points get too many, and
/// Error{cancelled}.
[[nodiscard]] Tetrahedra refine(const TriMesh& mesh, const Features& features,
                                const Refinement& wanted, const Progress& progress);

/// The same of a surface alone, which need not be closed: one region, with balls already placed
/// about the points of its curves, a chain of them for each. No tetrahedra, and triangles are not
/// turned. Points begin with the balls' centres. None where the generator gives up on its own.
[[nodiscard]] Tetrahedra refine_surface(const TriMesh& mesh, const Features& features,
                                        const CurvePoints& balls, const Refinement& wanted,
                                        const Progress& progress);

}  // namespace dupin::meshing
