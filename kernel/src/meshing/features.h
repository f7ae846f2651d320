#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dupin/kernel/mesh.h"

/// Meshes for solvers: triangles and tetrahedra of good shape in place of the long thin ones of an
/// exact union. given_solid.h is what they are made of, features.h says what stays, edge_lengths.h
/// how long edges along it may be, delaunay_refinement.h makes triangles and tetrahedra (CGAL's
/// Mesh_3) that begin at seeds.h, angle_improvement.h moves points where triangles beside sharp
/// edges are poor, and surface_distance.h proves how far the surface is from the one given.
/// solver_mesh_maker.h strings them together for tetrahedra. Surfaces are surface_mesh_maker.h's:
/// curve_points.h places points along curves, region_mesher.h gives each region a mesh that ends
/// there, of triangles that patch_topology.h turns outward, edge_cuts.h brings near the surface,
/// and edge_edits.h joins otherwise, or patch_trials.h makes anew, where they are poor still;
/// incidence.h knows which are at a point.
namespace dupin::meshing {

/// A polyline of sharp edges, from corner to corner or, if it ends where it begins, around.
struct Curve {
  std::vector<Vec3> points;
  std::array<std::uint32_t, 2> regions{};  ///< on both sides, which may be the same
};

/// What a mesh of the same solid keeps.
struct Features {
  std::vector<Curve> curves;
  std::vector<std::uint32_t> regions;  ///< per triangle: those that hang together smoothly
  /// Per triangle, a unit vector. Triangles too thin for their rounded corners to tell have that of
  /// the neighbour at their longest edge.
  std::vector<Vec3> normals;
  std::vector<std::uint8_t>
      is_absorbed;      ///< per triangle: of a thin region that became part of one
  double absorbed = 0;  ///< no place of a thin region is further from what it became part of
};

/// Edges of a closed 2-manifold mesh in which the surface turns by more than `angle`, in radians,
/// those between labels, and creases that a triangle across them would miss by far more than
/// `distance`, were its edges as long as `largest_edge`, or what is flat beside them wide: without
/// an edge there they would have to be tiny. So are creases along which what is flat is narrower
/// than edges, if they turn by more than 60 degrees. Curves are cut where they turn sharply, seen
/// over twice `distance`. Regions all of which lie within a quarter of it of a neighbour, or of
/// what that became part of, become part of it, or, where the surface folds back to it, if within a
/// sixteenth: slivers and steps that exact unions leave, whose borders would ask for triangles of
/// no size.
[[nodiscard]] Features find_features(const TriMesh& mesh, double angle, double distance,
                                     double largest_edge);

}  // namespace dupin::meshing
