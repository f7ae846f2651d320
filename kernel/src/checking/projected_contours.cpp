#include "checking/projected_contours.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "boxes/box_tree.h"
#include "boxes/tree_traversal.h"
#include "predicates/sign_filter.h"
#include "predicates/stable_predicates.h"
#include "predicates/triangle_overlap.h"
#include "support/blocks.h"
#include "support/disjoint_sets.h"
#include "support/none.h"
#include "support/sequences.h"

namespace dupin::checking {
namespace {

/// An end of an edge: where it begins or where it ends.
struct End {
  std::uint32_t point, edge;
  bool begins;
};

class Curves {
 public:
  Curves(std::span<const Vec3> points, std::span<const DirectedEdge> edges, int axis, int turn,
         double margin)
      : points_(points),
        edges_(edges),
        axis_(axis),
        u_((axis + 1) % 3),
        v_((axis + 2) % 3),
        turn_(turn),
        margin_(margin),
        curves_(edges.size()) {
    ends_.reserve(2 * edges.size());
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      ends_.insert(ends_.end(), {{edges[i].from, i, true}, {edges[i].to, i, false}});
    }
    std::ranges::stable_sort(ends_, {}, &End::point);
    at_points_ = support::ranges_of_equal(ends_, [](const End& end) { return end.point; });
    for (const support::IndexRange& at : at_points_) {
      for (std::uint32_t i = at.begin + 1; i < at.end; ++i) {
        curves_.unite(ends_[at.begin].edge, ends_[i].edge);
      }
    }
  }

  /// Edges that may meet others otherwise than in a common end, somewhere within the margin. Where
  /// there are none, neither the order of edges around points nor windings change therein.
  std::vector<std::uint32_t> crossing() {
    constexpr std::size_t kFew = 12, kTasks = 64;
    std::vector<std::uint32_t> found;
    const auto compare = [&](std::uint32_t i, std::uint32_t k) {
      if (meet(edges_[i], edges_[k])) {
        found.insert(found.end(), {i, k});
      }
    };
    if (edges_.size() <= kFew) {
      for (std::uint32_t i = 0; i < edges_.size(); ++i) {
        for (std::uint32_t k = 0; k < i; ++k) {
          compare(i, k);
        }
      }
      return found;
    }
    make_tree();
    const auto order = tree_->items();
    const boxes::TreeTraversal pairs(*tree_);
    for (const boxes::TreeTraversal::Nodes& nodes : pairs.tasks(kTasks)) {
      if (found.size() <= edges_.size()) {  // more would be of no use
        pairs.visit(nodes, [&](std::uint32_t i, std::uint32_t k) { compare(order[i], order[k]); });
      }
    }
    return found;
  }

  /// Of edges that do not cross, those around points where edges in and out do not alternate.
  std::vector<std::uint32_t> tangled() {
    std::vector<std::uint32_t> found;
    for (const support::IndexRange& at : at_points_) {
      const std::span<End> ends = std::span(ends_).subspan(at.begin, at.end - at.begin);
      if (ends.size() > 2) {
        std::ranges::sort(ends, [&](const End& a, const End& b) { return is_before(a, b); });
      }
      for (std::size_t i = 0; i < ends.size(); ++i) {
        if (ends[i].begins == ends[(i + 1) % ends.size()].begins) {
          found.push_back(ends[i].edge);
        }
      }
    }
    return found;
  }

  /// Of edges neither crossing nor tangled, one of each curve along which all do not wind about the
  /// one side once and about the other not at all.
  std::vector<std::uint32_t> misplaced() {
    std::vector<std::uint32_t> found;
    const bool alone = curves_.count() == 1;
    if (!alone) {
      make_tree();
    }
    std::vector<std::uint32_t> lowest(edges_.size(), support::kNone);  // run of ends, by curve
    for (std::uint32_t r = 0; r < at_points_.size(); ++r) {
      std::uint32_t& low = lowest[curves_.find(first_end(r).edge)];
      low = low == support::kNone || is_below(first_end(r).point, first_end(low).point) ? r : low;
    }
    for (const std::uint32_t r : lowest) {
      if (r == support::kNone) {
        continue;
      }
      const auto [begin, end] = at_points_[r];
      const End& outer =
          *std::min_element(ends_.begin() + begin, ends_.begin() + end,
                            [&](const End& a, const End& b) { return is_before(a, b); });
      const int windings = alone ? 0 : turn_ * windings_of_others(outer);
      if (windings != (outer.begins ? 0 : 1)) {
        found.push_back(outer.edge);
      }
    }
    return found;
  }

 private:
  [[nodiscard]] const End& first_end(std::uint32_t run) const {
    return ends_[at_points_[run].begin];
  }

  [[nodiscard]] int side(std::uint32_t a, std::uint32_t b, std::uint32_t p) const {
    const int quick = predicates::side_of_line(points_[a], points_[b], points_[p], axis_);
    return quick != 0 ? quick
                      : predicates::exact_side_of_line(points_[a], points_[b], points_[p], axis_);
  }

  /// The same if it stays within the margin, else 0.
  [[nodiscard]] int stable_side(std::uint32_t a, std::uint32_t b, std::uint32_t p) const {
    return margin_ == 0 ? side(a, b, p)
                        : predicates::stable_side_of_line(points_[a], points_[b], points_[p], axis_,
                                                          margin_);
  }

  [[nodiscard]] bool is_below(std::uint32_t a, std::uint32_t b) const {
    const Vec3 &p = points_[a], &q = points_[b];
    return p[u_] < q[u_] || (p[u_] == q[u_] && p[v_] < q[v_]);
  }

  [[nodiscard]] std::uint32_t far(const End& end) const {
    return end.begins ? edges_[end.edge].to : edges_[end.edge].from;
  }

  /// The order of edges around their common end, in the sense of the turn, from downward.
  [[nodiscard]] bool is_before(const End& a, const End& b) const {
    const std::uint32_t p = far(a), q = far(b);
    const bool above_p = is_below(a.point, p), above_q = is_below(a.point, q);
    return above_p != above_q ? above_p : turn_ * side(a.point, p, q) > 0;
  }

  /// False only if the edges meet at most in a common end, and go on to.
  [[nodiscard]] bool meet(const DirectedEdge& e, const DirectedEdge& f) const {
    const bool from_e = e.from == f.from || e.from == f.to, to_e = e.to == f.from || e.to == f.to;
    if (from_e && to_e) {
      return true;
    }
    if (from_e || to_e) {
      const std::uint32_t common = from_e ? e.from : e.to;
      return folds_back(from_e ? e.to : e.from, common, f.from == common ? f.to : f.from);
    }
    const auto on_one_side = [&](const DirectedEdge& line, const DirectedEdge& edge) {
      const int from = stable_side(line.from, line.to, edge.from);
      return from != 0 && from == stable_side(line.from, line.to, edge.to);
    };
    return !ranges_apart(e, f) && !on_one_side(e, f) && !on_one_side(f, e);
  }

  /// Whether one value stays above another: differences change by up to twice the margin, and the
  /// rounding of this one is made up for.
  [[nodiscard]] bool above(double one, double other) const {
    return one - other > 2 * margin_ * predicates::kStableMore;
  }

  [[nodiscard]] bool ranges_apart(const DirectedEdge& e, const DirectedEdge& f) const {
    return std::ranges::any_of(std::array{u_, v_}, [&](int k) {
      const auto [low_e, high_e] = std::minmax({points_[e.from][k], points_[e.to][k]});
      const auto [low_f, high_f] = std::minmax({points_[f.from][k], points_[f.to][k]});
      return above(low_f, high_e) || above(low_e, high_f);
    });
  }

  /// Whether the way from a over b to c may come back upon itself.
  [[nodiscard]] bool folds_back(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const auto goes_on = [&](int k) {
      const double from = points_[a][k], over = points_[b][k], to = points_[c][k];
      return (above(over, from) && above(to, over)) || (above(from, over) && above(over, to));
    };
    return stable_side(a, b, c) == 0 && !goes_on(u_) && !goes_on(v_);
  }

  void make_tree() {
    if (tree_) {
      return;
    }
    std::vector<Vec3> origins;
    std::vector<boxes::Box> boxes;
    origins.reserve(edges_.size());
    boxes.reserve(edges_.size());
    for (const DirectedEdge& edge : edges_) {
      origins.push_back(points_[edge.from]);
    }
    frame_.emplace(origins);
    for (const auto& [from, to] : edges_) {
      boxes.push_back(flat(box(points_[from], points_[to])));
    }
    tree_.emplace(boxes);
  }

  [[nodiscard]] boxes::Box box(const Vec3& from, const Vec3& to) const {
    const boxes::FramedTriangle framed = frame_->map(from, to, to);
    return margin_ == 0 ? frame_->around(framed) : frame_->around(framed, margin_);
  }

  [[nodiscard]] boxes::Box flat(boxes::Box box) const {
    const auto axis = static_cast<std::size_t>(axis_);
    box.low[axis] = box.high[axis] = 0;
    return box;
  }

  /// How often the other curves wind about an end, counted where they cross a ray downward.
  [[nodiscard]] int windings_of_others(const End& end) {
    const Vec3& p = points_[end.point];
    boxes::Box ray = flat(box(p, p));
    ray.low[static_cast<std::size_t>(u_)] = -std::numeric_limits<float>::infinity();
    const std::uint32_t own = curves_.find(end.edge);
    int windings = 0;
    tree_->visit(ray, [&](std::uint32_t edge) {
      const auto [from, to] = edges_[edge];
      const bool starts_below = points_[from][v_] <= p[v_], ends_below = points_[to][v_] <= p[v_];
      if (starts_below != ends_below && curves_.find(edge) != own) {
        const int way = starts_below ? -1 : 1;
        windings += side(from, to, end.point) == way ? way : 0;
      }
    });
    return windings;
  }

  std::span<const Vec3> points_;
  std::span<const DirectedEdge> edges_;
  int axis_, u_, v_, turn_;
  double margin_;
  std::vector<End> ends_;                       // by point
  std::vector<support::IndexRange> at_points_;  // of ends_
  support::DisjointSets curves_;                // of edges that hang together
  std::optional<boxes::BoxQuantizer> frame_;
  std::optional<boxes::BoxTree> tree_;
};

}  // namespace

std::vector<std::uint32_t> region_conflicts(std::span<const Vec3> points,
                                            std::span<const DirectedEdge> edges, int axis, int turn,
                                            double margin) {
  Curves curves(points, edges, axis, turn, margin);
  std::vector<std::uint32_t> conflicts = curves.crossing();
  if (conflicts.empty()) {
    conflicts = curves.tangled();
  }
  if (conflicts.empty()) {
    conflicts = curves.misplaced();
  }
  support::sort_unique(conflicts);
  return conflicts;
}

}  // namespace dupin::checking
