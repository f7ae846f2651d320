#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "boxes/box_tree.h"
#include "dupin/kernel/mesh.h"

/// How two things that should fit do fit, exactly, for dupin/kernel/gap.h and mesh_gap.h.
///
/// Ends of parts are rings: a ring in front of another one is a matter of signs and squared lengths
/// in rationals, and PortTree finds which ends belong together. Meshes have no rings, only faces:
/// both are put over one list of points (MeshPair, below), in which points in the same place are
/// one, so that shared faces and edges show in indices. Then boundary_loops names the edges of one
/// face, gap_regions the faces that look at each other across a thin space, and union_components
/// how many pieces the union has. Boxes (FaceBoxIndex) only spare pairs of faces that are far
/// apart.
namespace dupin::gaps {

/// Two meshes over one list of points in which identical points have one index: that of the first.
struct MeshPair {
  std::vector<Vec3> points;           ///< those of a, then those of b
  std::vector<Triangle> triangles;    ///< likewise, without those that repeat a corner
  std::vector<std::uint32_t> source;  ///< the triangle's index in its mesh
  std::vector<std::uint8_t> flat;     ///< corners on one line
  std::uint32_t points_of_a = 0, faces_of_a = 0;
  std::size_t flat_faces = 0;  ///< with those left out

  [[nodiscard]] bool in_a(std::uint32_t face) const { return face < faces_of_a; }
  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t face) const {
    const Triangle& t = triangles[face];
    return {points[t[0]], points[t[1]], points[t[2]]};
  }
  [[nodiscard]] std::span<const Triangle> of_a() const {
    return std::span(triangles).first(faces_of_a);
  }
  [[nodiscard]] std::span<const Triangle> of_b() const {
    return std::span(triangles).subspan(faces_of_a);
  }
};

/// Throws Error{invalid_argument} for a point that is not finite or an index out of range.
[[nodiscard]] MeshPair merged(const TriMesh& a, const TriMesh& b);

/// Finds the faces of the second mesh of a pair near a face of the first by their boxes. Faces
/// without area are left out. The pair outlives it.
class FaceBoxIndex {
 public:
  explicit FaceBoxIndex(const MeshPair& pair);

  /// Calls visit(face of b) at least for all faces whose distance from face `a` is at most `reach`.
  template <class Visit>
  void visit_near(std::uint32_t a, double reach, Visit&& visit) const {
    if (pair_.flat[a] == 0) {
      tree_.visit(around(a, reach), [&](std::uint32_t item) { visit(pair_.faces_of_a + item); });
    }
  }

 private:
  [[nodiscard]] boxes::Box around(std::uint32_t face, double reach) const;
  [[nodiscard]] std::vector<boxes::Box> boxes_of_b() const;

  const MeshPair& pair_;
  boxes::BoxQuantizer frame_;
  Eigen::AlignedBox3d bounds_;  // of all points
  boxes::BoxTree tree_;
};

}  // namespace dupin::gaps
