#pragma once

#include <cstddef>
#include <numbers>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/solid.h"

namespace dupin {

/// What a mesh for a solver has to be like. Lengths are in model units, angles in radians.
struct RemeshOptions {
  /// Largest distance from any point of either surface to the other.
  double distance = 0;
  /// Edges are sought to be at most so long; 0 stands for a tenth of the diagonal of the box around
  /// the solid.
  double largest_edge = 0;
  /// Refinement ends at edges of this length; 0 stands for the distance.
  double smallest_edge = 0;
  /// Triangles with a smaller angle are improved, as far as sharp edges allow.
  double smallest_angle = 25 * std::numbers::pi / 180;
  /// Edges where the surface turns by more are sharp, and kept. So are borders between labels.
  double feature_angle = 40 * std::numbers::pi / 180;
};

/// A triangle with an angle below the bound.
struct PoorTriangle {
  Vec3 place = Vec3::Zero();  ///< its centroid
  double angle = 0;           ///< its smallest, in radians
  /// Whether sharp edges leave it no better one: two of them meet in an angle below the bound at a
  /// corner of it, or come nearer to each other, or to their ends, than the smallest edge.
  bool is_confined = false;
};

/// How well it went.
struct RemeshReport {
  /// A proved bound of the distance from every point of either surface to the other, beyond that of
  /// rounding to doubles; at most the one allowed.
  double deviation = 0;
  double angle_bound = 0;  ///< that was asked for, in radians, as all angles
  double smallest_angle = 0, shortest_edge = 0, longest_edge = 0;
  std::size_t poor_triangles = 0;      ///< below the bound
  std::size_t confined_triangles = 0;  ///< of these
  std::vector<PoorTriangle> worst;     ///< up to 10, those that are not confined first
};

struct Remeshed {
  Solid solid;  ///< labelled as the one given
  RemeshReport report;
};

/// A mesh of well-shaped triangles for the same solid: what generators of volume meshes take. Long
/// edges are split, short ones collapsed, edges flipped and points moved along the surface, towards
/// sizes that follow from its curvature, from the distance between sharp edges, and from each other
/// [Botsch and Kobbelt, A Remeshing Approach to Multiresolution Modeling, 2004]. Borders between
/// labels and sharp edges are curves that points move along, their ends and forks stay. Every batch
/// of edits is checked by exact predicates, and what would make the surface touch or cross itself
/// is undone. The distance is proved at the end, both ways: that to a triangle is convex, so its
/// largest value over another one is taken in a corner. The same input gives the same mesh.
/// Throws Error{invalid_argument} for options outside their range, Error{limit_exceeded} where
/// sizes ask for more than 8 million triangles, and Error{unroundable} as `to_mesh`, or, never
/// giving a worse mesh, where the distance cannot be kept.
[[nodiscard]] Remeshed remesh(const Solid& solid, const RemeshOptions& options);

}  // namespace dupin
