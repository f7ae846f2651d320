#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include <Eigen/Geometry>

#include "boxes/box.h"
#include "boxes/oriented_box.h"
#include "dupin/kernel/mesh.h"
#include "support/bulk_vector.h"

/// Boxes around triangles, which name the pairs that may meet. They only ever spare work: what is
/// decided of a pair is decided by exact predicates.
///
/// A BoxQuantizer maps coordinates to floats in [-1, 1], along the axes in which boxes are small
/// (main_directions), and makes a Box of each triangle that contains it, rounding included. A
/// BoxTree is a tree over such boxes, an implicit one: node i of a level has the children 4i to 4i
/// + 3 of the level below, whose boxes it has side by side (BoxQuad), the leaves four items each.
/// One tree is asked for what is near one box (BoxTree::visit), a list of boxes (boxes_near), or
/// another tree, or itself (TreeTraversal). Where long slanted facets leave boxes empty, nodes have
/// an OrientedBox besides [GLM96].
namespace dupin::boxes {

/// Maps coordinates to floats between -1 and 1 about the middle of a point set.
class BoxQuantizer {
 public:
  /// Along the coordinate axes. The map is monotone per coordinate, so boxes that overlap do so
  /// after it as well: no outward rounding is needed.
  explicit BoxQuantizer(std::span<const Vec3> points);
  /// Along axes in which boxes around the triangles are small: those of most long edges, unless the
  /// coordinate axes do as well. Boxes contain their triangles, rounding included.
  BoxQuantizer(std::span<const Vec3> points, std::span<const Triangle> triangles);
  /// The same of triangles within these bounds; points that are of none may be anything.
  BoxQuantizer(const Eigen::AlignedBox3d& bounds, std::span<const Vec3> points,
               std::span<const Triangle> triangles);

  [[nodiscard]] FramedPoint map(const Vec3& point) const {
    const Vec3 from_middle = (point - middle_) * scale_;
    return (axes_ ? Vec3(*axes_ * from_middle) : from_middle).cast<float>();
  }
  [[nodiscard]] FramedTriangle map(const Vec3& a, const Vec3& b, const Vec3& c) const {
    return {map(a), map(b), map(c)};
  }
  [[nodiscard]] support::BulkVector<FramedPoint> map(std::span<const Vec3> points) const;

  /// Of corners that have been mapped.
  [[nodiscard]] Box around(const FramedTriangle& triangle) const {
    const auto& [a, b, c] = triangle;
    Box box;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      box.low[k] = std::min({a[axis], b[axis], c[axis]}) - rounding_;
      box.high[k] = std::max({a[axis], b[axis], c[axis]}) + rounding_;
    }
    return box;
  }
  /// About all that is mapped from a box.
  [[nodiscard]] Box around(const Eigen::AlignedBox3d& box) const;
  /// Contains the boxes of triangles with corners within `margin` of these.
  [[nodiscard]] Box around(const FramedTriangle& triangle, double margin) const;

 private:
  explicit BoxQuantizer(const Eigen::AlignedBox3d& bounds);

  Vec3 middle_;
  double scale_;                         // a power of two
  std::optional<Eigen::Matrix3d> axes_;  // rows; none if these are the coordinate axes
  float rounding_ = 0;                   // to be added to boxes
};

}  // namespace dupin::boxes
