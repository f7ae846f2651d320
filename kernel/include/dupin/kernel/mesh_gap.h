#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <gmpxx.h>

#include "dupin/kernel/enclosure.h"
#include "dupin/kernel/mesh.h"

namespace dupin {

/// A chain of edges that have a face on one side only.
struct BoundaryLoop {
  /// Indices into the mesh's points, in order, the faces on the left; the lowest of identical
  /// points stands for all of them.
  std::vector<std::uint32_t> points;
  bool closed = true;  ///< false only where faces are inconsistently oriented
  Enclosure length;    ///< in model units
  Vec3 place;          ///< the mean of its points
};

/// A region where faces of two meshes look at each other across a thin space.
struct GapRegion {
  std::vector<std::uint32_t> faces_a, faces_b;  ///< indices into triangles, ascending
  std::size_t pairs = 0;                        ///< of faces that see each other
  mpq_class least_squared, greatest_squared;    ///< exact squared distances of its nearest and its
                                                ///< farthest pair; 0 where the faces touch
  Enclosure least, greatest;                    ///< their roots
  Vec3 place;                                   ///< a point between the nearest pair
};

/// How two meshes fit.
struct MeshGapReport {
  std::vector<BoundaryLoop> boundary_a, boundary_b;  ///< by lowest point
  std::vector<GapRegion> facing;                     ///< by lowest face of a
  std::size_t welded_faces = 0;  ///< faces of a that b has too, by coordinates, the other way round
  std::size_t flat_faces = 0;    ///< faces without area in both meshes, left out of all else
  bool touching = false;         ///< the surfaces have at least one point in common
  std::size_t components = 0;    ///< connected pieces of the union of the two solids

  [[nodiscard]] bool one_component() const { return components == 1; }
  /// The union leaves a thin space between faces that look at each other.
  [[nodiscard]] bool slit() const { return !facing.empty(); }
};

struct MeshGapOptions {
  double connect = 0;   ///< faces farther apart than this do not belong together; model units
  double cosine = 0.9;  ///< two faces look at each other only if the cosine of the angle between
                        ///< one normal and the other reversed is at least this; in (0, 1]
};

/// Boundary loops of each mesh, and the faces of `a` and `b` that nearly coincide: that look at
/// each other from at most `connect` away without being the same, part of each straight in front of
/// the other. Every decision and distance is exact. Faces that have passed each other are no gap:
/// there the solids overlap.
///
/// `components` takes the meshes for solids: pieces that touch, cross or share faces are one, and
/// so are pieces inside the material of the other mesh (asked only if neither has a boundary).
///
/// O(n log n) if every face has O(1) others within `connect`. Throws Error{invalid_argument} for
/// points that are not finite or out of range, indices out of range, and options out of range.
[[nodiscard]] MeshGapReport measure_gaps(const TriMesh& a, const TriMesh& b,
                                         const MeshGapOptions& options = {});

}  // namespace dupin
