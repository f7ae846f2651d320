#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include <Eigen/Core>

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

/// A box along the axes, and in the single precision coordinates, of a BoxQuantizer.
struct Box {
  std::array<float, 3> low, high;

  [[nodiscard]] bool overlaps(const Box& other) const {
    return (low[0] <= other.high[0]) & (other.low[0] <= high[0]) & (low[1] <= other.high[1]) &
           (other.low[1] <= high[1]) & (low[2] <= other.high[2]) & (other.low[2] <= high[2]);
  }
  [[nodiscard]] bool contains(const Box& other) const;
  /// Makes the box contain `other` too.
  void join(const Box& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
  /// Contains nothing, overlaps nothing.
  [[nodiscard]] static Box nothing();
  [[nodiscard]] bool is_nothing() const { return high[0] < low[0]; }
};

/// Maps coordinates to floats between -1 and 1 about the middle of a point set.
class BoxQuantizer {
 public:
  /// Along the coordinate axes. The map is monotone per coordinate, so boxes that overlap do so
  /// after it as well: no outward rounding is needed.
  explicit BoxQuantizer(std::span<const Vec3> points);
  /// Along axes in which boxes around the triangles are small: those of most long edges, unless the
  /// coordinate axes do as well. Boxes contain their triangles, rounding included.
  BoxQuantizer(std::span<const Vec3> points, std::span<const Triangle> triangles);

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
  /// Contains the boxes of triangles with corners within `margin` of these.
  [[nodiscard]] Box around(const FramedTriangle& triangle, double margin) const;

 private:
  Vec3 middle_;
  double scale_;                         // a power of two
  std::optional<Eigen::Matrix3d> axes_;  // rows; none if these are the coordinate axes
  float rounding_ = 0;                   // to be added to boxes
};

}  // namespace dupin::boxes
