#include "self_intersection.h"

#include <algorithm>
#include <array>
#include <optional>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include "box_tree.h"
#include "flat_stars.h"
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
        frame_(points),
        corners_(triangles.size()),
        degenerate_(triangles.size()),
        tree_(prepare()) {}

  SelfIntersections run() {
    if (active_.empty()) {
      return {};
    }
    placed_.reserve(active_.size());
    if (active_.size() == triangles_.size()) {
      flat_stars_ = flat_stars(points_, corners_);
      group_large_stars();
    }
    for (const std::uint32_t item : tree_.items()) {
      placed_.push_back({corners_[active_[item]], active_[item]});
    }
    SelfIntersections found =
        examined(tree_.leaf_count(),
                 [&](std::uint32_t leaf, SelfIntersections& part) { examine_active(leaf, part); });
    if (active_.size() < triangles_.size()) {
      const auto others = static_cast<std::uint32_t>(triangles_.size());
      found = joined(std::move(found),
                     examined(others, [&](std::uint32_t face, SelfIntersections& part) {
                       examine_passive(face, part);
                     }));
    }
    trim(found.pairs);
    for (const std::uint32_t face : active_) {
      if (degenerate_[face] != 0) {
        found.degenerate.push_back(face);
      }
    }
    return found;
  }

 private:
  struct Placed {
    Triangle corners;
    std::uint32_t face;
  };

  /// Fills corners_ and active_, degenerate_ where active, and returns the tree over the active
  /// triangles.
  BoxTree prepare() {
    tbb::parallel_for(std::size_t{0}, triangles_.size(), [&](std::size_t i) {
      for (int k = 0; k < 3; ++k) {
        corners_[i][k] = first_identical_[triangles_[i][k]];
      }
    });
    for (std::uint32_t i = 0; i < points_.size() && !touching_apart_; ++i) {
      touching_apart_ = first_identical_[i] != i;
    }
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      if (active(i)) {
        active_.push_back(i);
      }
    }
    std::vector<Box> boxes(active_.size());
    tbb::parallel_for(std::size_t{0}, active_.size(), [&](std::size_t i) {
      const std::uint32_t face = active_[i];
      degenerate_[face] = is_degenerate(face) ? 1 : 0;
      boxes[i] = degenerate_[face] != 0 ? Box::nothing() : box(face);
    });
    return BoxTree(boxes, [&](std::uint32_t i) { return framed(active_[i]); });
  }

  /// Pairs of triangles around one point of many need not even be found, unless they are contacts.
  void group_large_stars() {
    constexpr std::uint32_t kLarge = 64;
    if (touching_apart_ || std::ranges::none_of(flat_stars_, [](auto n) { return n >= kLarge; })) {
      return;
    }
    std::vector<std::uint32_t> groups;
    groups.reserve(corners_.size());
    for (const Triangle& t : corners_) {
      const auto largest = std::ranges::max(t, {}, [&](std::uint32_t v) { return flat_stars_[v]; });
      groups.push_back(flat_stars_[largest] >= kLarge ? largest : BoxTree::kNoGroup);
    }
    tree_.group(groups);
  }

  [[nodiscard]] Box box(std::uint32_t face) const {
    const Triangle& t = corners_[face];
    return frame_.around(points_[t[0]], points_[t[1]], points_[t[2]]);
  }

  [[nodiscard]] bool is_degenerate(std::uint32_t face) const {
    const Triangle& t = corners_[face];
    const Vec3 &a = points_[t[0]], &b = points_[t[1]], &c = points_[t[2]];
    return !PlaneFilter(a, b, c).certain() && collinear(a, b, c);
  }

  [[nodiscard]] FramedTriangle framed(std::uint32_t face) const {
    const Triangle& t = corners_[face];
    return frame_.mapped(points_[t[0]], points_[t[1]], points_[t[2]]);
  }

  [[nodiscard]] bool active(std::uint32_t triangle) const {
    return options_.active.empty() || options_.active[triangle] != 0;
  }

  /// Calls examine(i, part) for all i below `count`, in parallel, and joins the parts.
  template <class Examine>
  SelfIntersections examined(std::uint32_t count, Examine&& examine) const {
    using Range = tbb::blocked_range<std::uint32_t>;
    return tbb::parallel_reduce(
        Range(0, count, 256), SelfIntersections{},
        [&](const Range& range, SelfIntersections part) {
          for (std::uint32_t i = range.begin(); i != range.end(); ++i) {
            examine(i, part);
          }
          return part;
        },
        [&](SelfIntersections left, const SelfIntersections& right) {
          return joined(std::move(left), right);
        });
  }

  /// Pairs of active triangles.
  void examine_active(std::uint32_t leaf, SelfIntersections& found) const {
    std::array<std::optional<TriangleProbe>, BoxTree::kLeafSize> probes;
    tree_.visit_pairs(leaf, [&](std::uint32_t i, std::uint32_t k) {
      const Placed &one = placed_[i], &other = placed_[k];
      if (share_flat_star(one.corners, other.corners)) {
        record(one.face, other.face, Meeting::none, found);
        return;
      }
      auto& probe = probes[i % BoxTree::kLeafSize];
      if (!probe) {
        probe.emplace(points_, one.corners);
      }
      record(one.face, other.face, probe->meeting(other.corners), found);
    });
  }

  /// Whether the triangles have a corner in common around which triangles keep apart.
  [[nodiscard]] bool share_flat_star(const Triangle& a, const Triangle& b) const {
    if (flat_stars_.empty()) {
      return false;
    }
    return std::ranges::any_of(a, [&](std::uint32_t v) {
      return (v == b[0] || v == b[1] || v == b[2]) && flat_stars_[v] != 0;
    });
  }

  /// Pairs of a passive and an active triangle.
  void examine_passive(std::uint32_t face, SelfIntersections& found) const {
    if (active(face)) {
      return;
    }
    const Box around = box(face);
    if (!tree_.overlaps(around)) {
      return;
    }
    std::optional<TriangleProbe> probe;  // few passive triangles need it
    tree_.visit(around, framed(face), [&](std::uint32_t item) {
      if (!probe) {
        if (is_degenerate(face)) {
          return;
        }
        probe.emplace(points_, corners_[face]);
      }
      const std::uint32_t other = active_[item];
      record(face, other, probe->meeting(corners_[other]), found);
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
        if (!touching_apart_ || !touch_apart(face, other)) {
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
  BoxFrame frame_;
  std::vector<Triangle> corners_;  // with identical points merged
  bool touching_apart_ = false;    // whether there are identical points
  std::vector<std::uint8_t> degenerate_;
  std::vector<std::uint32_t> active_;
  BoxTree tree_;
  std::vector<Placed> placed_;             // the active triangles in the order of the tree
  std::vector<std::uint32_t> flat_stars_;  // empty if few triangles are active
};

}  // namespace

SelfIntersections find_self_intersections(std::span<const Vec3> points,
                                          std::span<const Triangle> triangles,
                                          const SelfIntersectionOptions& options) {
  return Search(points, triangles, options).run();
}

}  // namespace dupin::detail
