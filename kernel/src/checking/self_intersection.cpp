#include "checking/self_intersection.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <iterator>
#include <numeric>
#include <optional>

#include "boxes/box_tree.h"
#include "boxes/boxes_near.h"
#include "boxes/tree_traversal.h"
#include "checking/crowded_points.h"
#include "checking/disjoint_face_groups.h"
#include "mesh/coincident_points.h"
#include "predicates/stable_predicates.h"
#include "predicates/triangle_overlap.h"
#include "support/blocks.h"
#include "support/none.h"
#include "support/sequences.h"

namespace dupin::checking {
namespace {

class Search {
 public:
  Search(std::span<const Vec3> points, std::span<const Triangle> triangles,
         const SelfIntersectionOptions& options)
      : points_(points),
        triangles_(triangles),
        options_(options),
        own_representatives_(options.representatives.empty()
                                 ? mesh::coincident_representatives(points)
                                 : std::vector<std::uint32_t>()),
        representatives_(options.representatives.empty()
                             ? std::span<const std::uint32_t>(own_representatives_)
                             : options.representatives),
        frame_(points, triangles),
        corners_(triangles),
        degenerate_(triangles.size()),
        tree_(prepare()) {}

  SelfIntersections run() {
    if (active_.empty()) {
      return {};
    }
    const Items items(tree_, active_, corners_);
    SelfIntersections found = examined(boxes::TreeTraversal(tree_), items, items);
    for (const CrowdedPoint& crowded : crowded_) {
      found = joined(std::move(found), examined_around(crowded));
    }
    if (!among_all_) {
      found = joined(std::move(found), examined_passive(items));
    }
    trim(found.pairs);
    found.is_cut_short = has_enough();
    if (!tree_.is_oriented()) {  // else boxes tell triangles apart that may not stay so
      std::ranges::replace(stable_, kSliver, std::uint8_t{0});
      found.stable = std::move(stable_);
    }
    for (const std::uint32_t face : active_) {
      if (degenerate_[face] != 0 && active(face)) {
        found.degenerate.push_back(face);
      }
    }
    std::ranges::sort(found.degenerate);
    return found;
  }

 private:
  /// The triangles that the items of a tree are, in the tree's order: neighbours there are looked
  /// at one after another.
  struct Items {
    Items(const boxes::BoxTree& tree, std::span<const std::uint32_t> faces,
          std::span<const Triangle> all)
        : face(tree.size()), corners(tree.size()) {
      support::for_each_block(tree.size(), [&](const support::Block& block) {
        for (std::size_t i = block.begin; i < block.end; ++i) {
          face[i] = faces[tree.items()[i]];
          corners[i] = all[face[i]];
        }
      });
    }
    support::BulkVector<std::uint32_t> face;
    support::BulkVector<Triangle> corners;
  };

  /// Fills what comes before it and returns the tree over the active triangles.
  boxes::BoxTree prepare() {
    for (std::uint32_t i = 0; i < points_.size() && !touching_apart_; ++i) {
      touching_apart_ = representatives_[i] != i;
    }
    if (touching_apart_) {
      merge_corners();
    } else if (options_.margin > 0 && options_.active.empty() &&
               predicates::is_small_margin(points_, triangles_, options_.margin)) {
      stable_.assign(triangles_.size(), 1);
    }
    choose_active();
    support::for_each_block(active_.size(), [&](const support::Block& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        const std::uint32_t face = active_[i];
        degenerate_[face] = is_degenerate(face) ? 1 : 0;
        if (seeks_stable() && !keeps_area(face)) {
          stable_[face] = kSliver;
        }
      }
    });
    find_crowded_points();
    const std::vector<std::uint32_t> with_crowds = groups_with_crowds();
    std::span<const std::uint32_t> groups = crowded_.empty() ? groups_.of_face : with_crowds;
    std::vector<std::uint32_t> of_active;
    if (!groups.empty() && (!crowded_.empty() || active_.size() < triangles_.size())) {
      of_active = support::selected(groups, active_);
      groups = of_active;
    }
    return {static_cast<std::uint32_t>(active_.size()),
            [&](std::uint32_t i) {
              return degenerate_[active_[i]] != 0 ? boxes::Box::nothing() : box(active_[i]);
            },
            [&](std::uint32_t i) { return framed(active_[i]); }, groups};
  }

  /// Points whose active triangles are looked at from there, as far as they have no group. These
  /// come together, so that what the tree has around them is no larger than it must be.
  void find_crowded_points() {
    std::vector<std::uint32_t> faces;
    std::ranges::copy_if(active_, std::back_inserter(faces),
                         [&](std::uint32_t f) { return !of_group(f) && degenerate_[f] == 0; });
    std::vector<std::uint8_t> several(seeks_contacts() ? points_.size() : 0);  // with contacts
    for (std::uint32_t i = 0; i < several.size(); ++i) {
      several[representatives_[i]] = representatives_[i] != i ? 1 : several[representatives_[i]];
    }
    crowded_ = crowded_points(corners_, faces, points_.size(), several, kCrowd);
    std::vector<std::uint8_t> moved(crowded_.empty() ? 0 : triangles_.size());
    for (const CrowdedPoint& crowded : crowded_) {
      std::ranges::for_each(crowded.faces, [&](std::uint32_t f) { moved[f] = 1; });
    }
    if (!crowded_.empty()) {
      std::erase_if(active_, [&](std::uint32_t f) { return moved[f] != 0; });
    }
    for (const CrowdedPoint& crowded : crowded_) {
      active_.insert(active_.end(), crowded.faces.begin(), crowded.faces.end());
    }
    for (const CrowdedPoint& crowded : crowded_) {
      for (std::size_t i = 0; i < crowded.faces.size() && seeks_stable(); ++i) {
        std::uint8_t& stable = stable_[crowded.faces[i]];
        stable = stable == kSliver ? kSliver : 0;  // directions may be apart by little
      }
    }
  }

  /// Per triangle a group, none of whose pairs the tree has to name: they keep apart, or belong to
  /// a crowded point. Empty if there are no such points.
  [[nodiscard]] std::vector<std::uint32_t> groups_with_crowds() const {
    if (crowded_.empty()) {
      return {};
    }
    std::vector<std::uint32_t> groups = groups_.of_face;
    groups.resize(triangles_.size(), support::kNone);
    std::uint32_t next = 0;
    for (const std::uint32_t group : groups) {
      next = group == support::kNone ? next : std::max(next, group + 1);
    }
    for (const CrowdedPoint& crowded : crowded_) {
      for (const std::uint32_t face : crowded.faces) {
        groups[face] = next;
      }
      ++next;
    }
    return groups;
  }

  /// The triangles to be searched among themselves and, unless all are, with the others.
  void choose_active() {
    for (std::uint32_t i = 0; i < triangles_.size() && !options_.active.empty(); ++i) {
      if (active(i)) {
        active_.push_back(i);
      }
    }
    const bool all = options_.active.empty();
    among_all_ = all || 2 * active_.size() > triangles_.size();  // then that is quicker
    if (among_all_ || !active_.empty()) {
      framed_ = frame_.map(points_);
    }
    if (!among_all_) {
      return;
    }
    find_groups();
    if (!options_.groups.empty()) {
      active_ =
          boxes::boxes_near_other_groups(groups_.of_face, [&](std::uint32_t f) { return box(f); });
    } else {
      active_.resize(triangles_.size());
      std::iota(active_.begin(), active_.end(), 0U);
    }
  }

  void merge_corners() {
    merged_.resize(triangles_.size());
    support::for_each_block(triangles_.size(), [&](const support::Block& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          merged_[i][k] = representatives_[triangles_[i][k]];
        }
      }
    });
    corners_ = merged_;
  }

  [[nodiscard]] bool seeks_contacts() const { return touching_apart_ && options_.contacts; }
  [[nodiscard]] bool seeks_stable() const { return !stable_.empty(); }

  /// Whether it may lose its area, which is known before pairs are examined.
  [[nodiscard]] bool is_sliver(std::uint32_t face) {
    return std::atomic_ref(stable_[face]).load(std::memory_order_relaxed) == kSliver;
  }

  /// Finds groups of triangles that certainly keep apart.
  void find_groups() {
    const WeldedMesh mesh{points_, triangles_, corners_, representatives_};
    groups_ = options_.groups.empty()
                  ? proven_groups(mesh, options_.closed, seeks_stable() ? options_.margin : 0,
                                  options_.rim)
                  : given_groups(mesh, options_.groups);
  }

  [[nodiscard]] boxes::Box box(std::uint32_t face) const {
    return seeks_stable() ? frame_.around(framed(face), kDiagonal * options_.margin)
                          : frame_.around(framed(face));
  }

  /// Whether it is of a group, all of which keep their areas.
  [[nodiscard]] bool of_group(std::uint32_t face) const {
    return !groups_.of_face.empty() && groups_.of_face[face] != support::kNone;
  }

  [[nodiscard]] bool is_degenerate(std::uint32_t face) const {
    const auto& [a, b, c] = corners_[face];
    return !of_group(face) && predicates::collinear(points_[a], points_[b], points_[c]);
  }

  [[nodiscard]] bool keeps_area(std::uint32_t face) const {
    const auto& [a, b, c] = corners_[face];
    return of_group(face) ||
           predicates::keeps_area(points_[a], points_[b], points_[c], options_.margin);
  }

  [[nodiscard]] boxes::FramedTriangle framed(std::uint32_t face) const {
    const Triangle& t = corners_[face];
    return {framed_[t[0]], framed_[t[1]], framed_[t[2]]};
  }

  [[nodiscard]] bool active(std::uint32_t triangle) const {
    return options_.active.empty() || options_.active[triangle] != 0;
  }

  /// Examines pairs of triangles of two trees.
  SelfIntersections examined(const boxes::TreeTraversal& pairs, const Items& items,
                             const Items& others) {
    constexpr std::size_t kTasks = 512;
    const std::vector<boxes::TreeTraversal::Nodes> tasks = pairs.tasks(kTasks);
    std::vector<SelfIntersections> parts(tasks.size());
    support::for_each_in_parallel(tasks.size(), [&](std::size_t i) {
      if (!has_enough()) {
        examine(pairs, tasks[i], items, others, parts[i]);
        found_count_.fetch_add(parts[i].count(), std::memory_order_relaxed);
      }
    });
    SelfIntersections found;
    for (const SelfIntersections& part : parts) {
      found = joined(std::move(found), part);
    }
    return found;
  }

  [[nodiscard]] bool has_enough() const {
    return found_count_.load(std::memory_order_relaxed) >= options_.enough;
  }

  /// Pairs of triangles of a crowded point that share directions.
  SelfIntersections examined_around(const CrowdedPoint& crowded) {
    const boxes::BoxTree tree(direction_boxes(points_, corners_, crowded, degenerate_));
    const Items items(tree, crowded.faces, corners_);
    return examined(boxes::TreeTraversal(tree), items, items);
  }

  void examine(const boxes::TreeTraversal& pairs, const boxes::TreeTraversal::Nodes& nodes,
               const Items& items, const Items& others, SelfIntersections& found) {
    // The items of a leaf are met again with those of the next one.
    std::array<std::optional<predicates::TriangleOverlapTest>, boxes::BoxTree::kFan> probes;
    std::array<std::uint32_t, boxes::BoxTree::kFan> probed{};
    pairs.visit(nodes, [&](std::uint32_t i, std::uint32_t k) {
      const Triangle &corners = items.corners[i], &other_corners = others.corners[k];
      const std::uint32_t face = items.face[i], other = others.face[k];
      if (!active(face) && !active(other)) {
        return;  // all are looked at, where most are active
      }
      if (options_.examined && !options_.examined(face, other)) {
        return;
      }
      if (share_injective_star(corners, other_corners)) {
        record(face, other, predicates::TriangleOverlap::none, found);
        return;
      }
      if (seeks_stable() && !is_sliver(face) && !is_sliver(other)) {
        if (predicates::keep_apart(points_, corners, other_corners, options_.margin)) {
          return;
        }
        for (const std::uint32_t f : {face, other}) {
          std::atomic_ref(stable_[f]).store(0, std::memory_order_relaxed);
        }
      }
      auto& probe = probes[i % boxes::BoxTree::kFan];
      if (std::uint32_t& last = probed[i % boxes::BoxTree::kFan]; !probe || last != i) {
        probe.emplace(points_, corners);
        last = i;
      }
      record(face, other, probe->meeting(other_corners), found);
    });
  }

  /// Pairs of a passive and an active triangle.
  SelfIntersections examined_passive(const Items& actives) {
    const auto near = boxes::boxes_near(tree_, triangles_.size(), [&](std::uint32_t face) {
      return active(face) ? boxes::Box::nothing() : box(face);
    });
    support::BulkVector<boxes::Box> boxes(near.size());
    support::for_each_block(near.size(), [&](const support::Block& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        boxes[i] = is_degenerate(near[i]) ? boxes::Box::nothing() : box(near[i]);
      }
    });
    const boxes::BoxTree tree(boxes, [&](std::uint32_t i) { return framed(near[i]); });
    return examined(boxes::TreeTraversal(tree, tree_), {tree, near, corners_}, actives);
  }

  /// Whether the triangles have a corner in common around which triangles keep apart.
  [[nodiscard]] bool share_injective_star(const Triangle& a, const Triangle& b) const {
    if (groups_.injective_stars.empty()) {
      return false;
    }
    return std::ranges::any_of(a, [&](std::uint32_t v) {
      return (v == b[0] || v == b[1] || v == b[2]) && groups_.injective_stars[v] != 0;
    });
  }

  void record(std::uint32_t face, std::uint32_t other, predicates::TriangleOverlap meeting,
              SelfIntersections& found) const {
    if (meeting == predicates::TriangleOverlap::none && !seeks_contacts()) {
      return;
    }
    FacePair pair{std::min(face, other), std::max(face, other)};
    std::size_t* count = &found.crossings;
    if (meeting == predicates::TriangleOverlap::overlap) {
      pair.kind = FacePair::Kind::overlap;
      count = &found.overlaps;
    } else if (meeting == predicates::TriangleOverlap::none) {
      if (!touch_apart(face, other)) {
        return;
      }
      pair.kind = FacePair::Kind::contact;
      count = &found.contacts;
    }
    if (options_.wanted && !options_.wanted(pair)) {
      return;
    }
    ++*count;
    keep(pair, found.pairs);
  }

  /// Of a part's pairs the lowest, as a heap with the last one in front once there are enough:
  /// where millions cross, few are looked at again.
  void keep(const FacePair& pair, std::vector<FacePair>& pairs) const {
    if (pairs.size() < options_.limit) {
      pairs.push_back(pair);
      if (pairs.size() == options_.limit) {
        std::ranges::make_heap(pairs);
      }
    } else if (!pairs.empty() && pair < pairs.front()) {
      std::ranges::pop_heap(pairs);
      pairs.back() = pair;
      std::ranges::push_heap(pairs);
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

  static constexpr double kDiagonal = 1.75;   // of a cube, and more
  static constexpr std::size_t kCrowd = 256;  // below, all pairs are quicker
  static constexpr std::uint8_t kSliver = 2;

  std::span<const Vec3> points_;
  std::span<const Triangle> triangles_;
  const SelfIntersectionOptions& options_;
  std::vector<std::uint32_t> own_representatives_;  // unless they are given
  std::span<const std::uint32_t> representatives_;  // per point the first one that is the same
  boxes::BoxQuantizer frame_;
  support::BulkVector<boxes::FramedPoint> framed_;
  std::vector<Triangle> merged_;       // if there are identical points
  std::span<const Triangle> corners_;  // with these merged
  bool touching_apart_ = false;        // whether there are identical points
  bool among_all_ = true;              // else among active and between these and passive ones
  std::vector<std::uint8_t> degenerate_;
  std::vector<std::uint32_t> active_;
  DisjointFaceGroups groups_;  // empty if few triangles are active
  std::vector<CrowdedPoint> crowded_;
  std::vector<std::uint8_t> stable_;          // empty unless stable ones are sought
  std::atomic<std::size_t> found_count_ = 0;  // pairs, by the tasks that are done
  boxes::BoxTree tree_;                       // over the active triangles
};

}  // namespace

SelfIntersections find_self_intersections(std::span<const Vec3> points,
                                          std::span<const Triangle> triangles,
                                          const SelfIntersectionOptions& options) {
  return Search(points, triangles, options).run();
}

}  // namespace dupin::checking
