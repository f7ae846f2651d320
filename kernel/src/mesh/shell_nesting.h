#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "boxes/box_quantizer.h"
#include "boxes/box_tree.h"
#include "mesh/edge_table.h"
#include "mesh/exact_mesh.h"
#include "mesh/point_winding.h"
#include "mesh/ray_faces.h"

namespace dupin::mesh {

/// How many candidates a ray from within the face may have: the less, the smaller.
[[nodiscard]] double ray_cost(const MeshView& mesh, std::uint32_t face);

/// The face's centre of gravity, which lies on no other shell, as shells touch in vertices and
/// edges only.
[[nodiscard]] WindingPoint point_within(const MeshView& mesh, std::uint32_t face);

/// Answers which shells are around which, by exact ray tests. The shells are closed surfaces of
/// doubles. The mesh and the shells outlive it.
class ShellNest {
 public:
  ShellNest(const MeshView& mesh, const Shells& shells);

  /// Whether `inner` lies within the surface `outer`, another shell that it does not cross nor
  /// share an area with; they may touch. Disjoint boxes cost nothing.
  [[nodiscard]] bool encloses(std::size_t outer, std::size_t inner) const;
  /// The same of a shell whose box is within that of `outer`, by its test point.
  [[nodiscard]] bool encloses(std::size_t outer, const WindingPoint& point) const;
  /// On the shell, and on no other.
  [[nodiscard]] WindingPoint test_point(std::size_t shell) const;
  /// The number of other shells around it. They share no area with it and do not cross it.
  /// O(log n) for each of those in whose box it is, and the faces that a ray meets.
  [[nodiscard]] int depth(std::size_t shell) const;

  /// Calls visit(other) for each other shell whose box, larger by `margin` on all sides, contains
  /// that of `shell`, along the axes and along the mesh's main directions: long parts side by side
  /// are in each other's boxes only where they are askew to both.
  void visit_boxes_around(std::size_t shell, double margin,
                          const std::function<void(std::size_t)>& visit) const;

  /// Of each shell, in all its coordinates.
  [[nodiscard]] std::span<const Eigen::AlignedBox3d> boxes() const { return boxes_; }

 private:
  MeshView mesh_;
  const Shells& shells_;
  std::vector<Eigen::AlignedBox3d> boxes_;
  boxes::BoxQuantizer quantizer_;
  std::vector<boxes::Box> framed_;  ///< along main directions
  boxes::BoxTree tree_;
  std::vector<std::unique_ptr<const RayFaces>> large_;  ///< by shell; none of small ones
};

/// Of the volume of a shell around material, or of one around a void.
[[nodiscard]] constexpr int sign_at(int depth) { return depth % 2 == 0 ? 1 : -1; }

/// For each shell the number of other shells around it. The shells share no area and do not cross.
/// O(n log n) and, for each pair of which one is in the other's box, the faces that a ray meets.
[[nodiscard]] std::vector<int> nesting_depths(const MeshView& mesh, const Shells& shells);

}  // namespace dupin::mesh
