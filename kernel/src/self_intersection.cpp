#include "self_intersection.h"

#include <algorithm>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include "box_tree.h"
#include "identical_points.h"
#include "triangle_meeting.h"

namespace dupin::detail {
namespace {

class Search {
 public:
  Search(std::span<const Vec3> points, std::span<const Triangle> triangles,
         const SelfIntersectionOptions& options)
      : points_(points),
        triangles_(triangles),
        options_(options),
        first_identical_(first_identical(points)),
        corners_(triangles.size()),
        degenerate_(triangles.size()),
        tree_(prepare()) {}

  SelfIntersections run() const {
    using Range = tbb::blocked_range<std::uint32_t>;
    SelfIntersections found = tbb::parallel_reduce(
        Range(0, tree_.size(), 1024), SelfIntersections{},
        [&](const Range& range, SelfIntersections part) {
          for (std::uint32_t position = range.begin(); position != range.end(); ++position) {
            examine(position, part);
          }
          return part;
        },
        [&](SelfIntersections left, const SelfIntersections& right) {
          return joined(std::move(left), right);
        });
    trim(found.pairs);
    for (std::uint32_t i = 0; i < degenerate_.size(); ++i) {
      if (degenerate_[i] != 0) {
        found.degenerate.push_back(i);
      }
    }
    return found;
  }

 private:
  /// Fills corners_ and degenerate_ and returns the boxes' tree.
  BoxTree prepare() {
    const BoxFrame frame(points_);
    std::vector<Box> boxes(triangles_.size());
    tbb::parallel_for(std::size_t{0}, triangles_.size(), [&](std::size_t i) {
      for (int k = 0; k < 3; ++k) {
        corners_[i][k] = first_identical_[triangles_[i][k]];
      }
      const Vec3 &a = points_[corners_[i][0]], &b = points_[corners_[i][1]],
                 &c = points_[corners_[i][2]];
      degenerate_[i] = !PlaneFilter(a, b, c).certain() && collinear(a, b, c);
      boxes[i] = degenerate_[i] != 0 ? Box::nothing() : frame.around(a, b, c);
    });
    return BoxTree(boxes);
  }

  [[nodiscard]] bool active(std::uint32_t triangle) const {
    return options_.active.empty() || options_.active[triangle] != 0;
  }

  void examine(std::uint32_t position, SelfIntersections& found) const {
    const std::uint32_t face = tree_.item(position);
    const TriangleProbe probe(points_, corners_[face]);
    const bool all = active(face);
    tree_.visit_after(position, [&](std::uint32_t other) {
      if (all || active(other)) {
        record(face, other, probe.meeting(corners_[other]), found);
      }
    });
  }

  void record(std::uint32_t face, std::uint32_t other, Meeting meeting,
              SelfIntersections& found) const {
    FacePair pair{std::min(face, other), std::max(face, other)};
    switch (meeting) {
      case Meeting::crossing:
        ++found.crossings;
        break;
      case Meeting::overlap:
        pair.kind = FacePair::Kind::overlap;
        ++found.overlaps;
        break;
      case Meeting::none:
        if (!touch_apart(face, other)) {
          return;
        }
        pair.kind = FacePair::Kind::contact;
        ++found.contacts;
        break;
    }
    found.pairs.push_back(pair);
    if (found.pairs.size() / 2 >= std::max<std::size_t>(options_.limit, 1024)) {
      trim(found.pairs);
    }
  }

  /// Whether the triangles have a corner of the same coordinates under different indices.
  [[nodiscard]] bool touch_apart(std::uint32_t face, std::uint32_t other) const {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (corners_[face][i] == corners_[other][j] &&
            triangles_[face][i] != triangles_[other][j]) {
          return true;
        }
      }
    }
    return false;
  }

  SelfIntersections joined(SelfIntersections left, const SelfIntersections& right) const {
    left.pairs.insert(left.pairs.end(), right.pairs.begin(), right.pairs.end());
    left.crossings += right.crossings;
    left.overlaps += right.overlaps;
    left.contacts += right.contacts;
    if (left.pairs.size() > options_.limit) {
      trim(left.pairs);
    }
    return left;
  }

  void trim(std::vector<FacePair>& pairs) const {
    std::sort(pairs.begin(), pairs.end());
    pairs.resize(std::min(pairs.size(), options_.limit));
  }

  std::span<const Vec3> points_;
  std::span<const Triangle> triangles_;
  const SelfIntersectionOptions& options_;
  std::vector<std::uint32_t> first_identical_;
  std::vector<Triangle> corners_;  // with identical points merged
  std::vector<std::uint8_t> degenerate_;
  BoxTree tree_;
};

}  // namespace

SelfIntersections find_self_intersections(std::span<const Vec3> points,
                                          std::span<const Triangle> triangles,
                                          const SelfIntersectionOptions& options) {
  return Search(points, triangles, options).run();
}

}  // namespace dupin::detail
