#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include "dupin/kernel/vec.h"

namespace dupin::districts {

using TreePoint = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using TreeBox = boost::geometry::model::box<TreePoint>;
using TreeEntry = std::pair<TreeBox, std::uint32_t>;
using Tree = boost::geometry::index::rtree<TreeEntry, boost::geometry::index::rstar<16>>;

/// The tree takes finite coordinates whose sums are finite, too: what is beyond these touches all
/// that is.
constexpr double kFarthest = 1e300;

inline TreePoint tree_point(const Vec3& p) {
  return {std::clamp(p.x(), -kFarthest, kFarthest), std::clamp(p.y(), -kFarthest, kFarthest),
          std::clamp(p.z(), -kFarthest, kFarthest)};
}
inline TreeBox tree_box(const Eigen::AlignedBox3d& box) {
  return {tree_point(box.min()), tree_point(box.max())};
}

/// Of those that are not empty, and for which is_in(i).
template <class IsIn>
Tree tree_of(std::span<const Eigen::AlignedBox3d> boxes, const IsIn& is_in) {
  std::vector<TreeEntry> entries;
  entries.reserve(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].isEmpty() && is_in(i)) {
      entries.emplace_back(tree_box(boxes[i]), i);
    }
  }
  return Tree(entries);
}

/// Of all that are not empty.
inline Tree tree_of(std::span<const Eigen::AlignedBox3d> boxes) {
  return tree_of(boxes, [](std::uint32_t) { return true; });
}

/// Boxes and a tree of those that are not empty.
class BoxesInTree {
 public:
  explicit BoxesInTree(std::span<const Eigen::AlignedBox3d> boxes)
      : boxes_(boxes), tree_(tree_of(boxes)) {}

  [[nodiscard]] std::size_t size() const { return boxes_.size(); }
  const Eigen::AlignedBox3d& operator[](std::size_t i) const { return boxes_[i]; }
  /// Those that touch the box, ascending.
  [[nodiscard]] std::vector<std::uint32_t> touching(const Eigen::AlignedBox3d& box) const {
    std::vector<std::uint32_t> result;
    if (!box.isEmpty()) {
      const auto append = [&](const TreeEntry& entry) {
        if (boxes_[entry.second].intersects(box)) {
          result.push_back(entry.second);
        }
      };
      tree_.query(boost::geometry::index::intersects(tree_box(box)),
                  boost::make_function_output_iterator(append));
    }
    std::ranges::sort(result);
    return result;
  }

 private:
  std::span<const Eigen::AlignedBox3d> boxes_;
  Tree tree_;
};

}  // namespace dupin::districts
