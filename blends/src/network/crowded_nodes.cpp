#include "network/crowded_nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <span>

#include <Eigen/Geometry>

#include "dupin/kernel/decimal.h"
#include "network/passing_edges.h"
#include "numbers/angle.h"

namespace dupin::network {
namespace {

// How many changes may build on each other.
constexpr int kDepth = 3;
// Edges that are contracted, by the sum of their balls' radii: those whose balls overlap, those
// that lead to a bend, the others where nothing else helped.
constexpr double kOverlapping = 1, kLong = 4, kShort = 2;
// Of the length of its shortest edge: how far a hub lies from the node that it is split off.
constexpr std::array kHubDistances{0.35, 0.5, 0.65, 0.2};

class Planner {
 public:
  Planner(GraphPlan& plan, const std::map<std::string, std::string>& refused,
          std::vector<SourceNote>& notes)
      : plan_(plan), refused_(refused), notes_(notes), given_(plan.nodes().size()) {}

  void run() {
    std::vector<std::size_t> order(given_);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return degree(i); });
    for (const std::size_t node : order) {
      if (plan_.nodes()[node].kind != NodeKind::gone && !plan_.nodes()[node].is_planned) {
        settle(node);
        undo_.clear();
        tell_reasons();
      }
    }
  }

 private:
  [[nodiscard]] const Ball& ball(std::size_t node) const { return plan_.nodes()[node].ball; }
  [[nodiscard]] std::size_t degree(std::size_t node) const {
    return plan_.nodes()[node].edges.size();
  }

  void settle(std::size_t node) {
    const auto refused = refused_.find("node " + ball(node).name);
    if (refused != refused_.end() && degree(node) > 1) {
      make_ball(node, Misfit(refused->second));
      notes_.back().is_refusal = true;
      return;
    }
    if (plan_.plan(node)) {
      return;
    }
    const Misfit why = plan_.why_not();
    if (contract(node, kOverlapping, why, kDepth) || stretch(node, why) ||
        split(node, why, kDepth) || narrow(node, why) || contract(node, kShort, why, kDepth)) {
      return;
    }
    make_ball(node, why);
  }

  void make_ball(std::size_t node, const Misfit& why) {
    plan_.plan_ball(node);
    note(node, "a ball of radius " + decimal(kBall * ball(node).radius, kMessageDigits), why);
  }

  // Whether there is something smooth for the node, if need be after so many more changes.
  bool fits(std::size_t node, int depth) {
    if (refused_.contains("node " + ball(node).name)) {
      return false;
    }
    if (plan_.plan(node)) {
      return true;
    }
    const Misfit why = plan_.why_not();
    return depth > 0 && split(node, why, depth - 1);
  }

  void note(std::size_t node, const std::string& text, const Misfit& why) {
    reasons_.emplace_back(notes_.size(), why);
    notes_.push_back({ball(node).line, "node " + ball(node).name + ": " + text});
  }

  // Of the notes that stay.
  void tell_reasons() {
    for (const auto& [note, why] : reasons_) {
      notes_[note].text += ", as " + why.text();
    }
    reasons_.clear();
  }

  // A state to come back to.
  struct Mark {
    std::size_t changes, notes;
  };

  [[nodiscard]] Mark mark() const { return {undo_.size(), notes_.size()}; }

  void take_back(const Mark& mark) {
    for (; undo_.size() > mark.changes; undo_.pop_back()) {
      undo_.back().put_back(plan_);
    }
    notes_.resize(mark.notes);
    std::erase_if(reasons_, [&](const auto& reason) { return reason.first >= mark.notes; });
  }

  // Before these nodes and their neighbours are changed.
  void save(const std::vector<std::size_t>& nodes) {
    std::set<std::size_t> touched(nodes.begin(), nodes.end());
    for (const std::size_t node : nodes) {
      touched.merge(std::set(neighbours(node)));
    }
    undo_.emplace_back(plan_, std::vector(touched.begin(), touched.end()));
  }

  [[nodiscard]] std::set<std::size_t> neighbours(std::size_t node) const {
    std::set<std::size_t> result;
    for (const std::size_t edge : plan_.nodes()[node].edges) {
      result.insert(plan_.other_end(edge, node));
    }
    return result;
  }

  // Those of the nodes that had been planned, which are not any more.
  std::vector<std::size_t> unplanned(const std::set<std::size_t>& nodes) {
    std::vector<std::size_t> result;
    for (const std::size_t node : nodes) {
      if (plan_.nodes()[node].is_planned) {
        plan_.unplan(node);
        result.push_back(node);
      }
    }
    std::ranges::stable_sort(result, std::greater{}, [&](std::size_t i) { return degree(i); });
    return result;
  }

  bool plan_again(const std::vector<std::size_t>& nodes) {
    return std::ranges::all_of(nodes, [&](std::size_t node) {
      if (plan_.nodes()[node].kind == NodeKind::ball) {
        plan_.plan_ball(node);
        return true;
      }
      return plan_.nodes()[node].kind == NodeKind::gone || plan_.plan(node);
    });
  }

  // Whether none of the node's edges leads from a ball into one that holds it.
  [[nodiscard]] bool has_cones(std::size_t node) const {
    return std::ranges::all_of(plan_.nodes()[node].edges, [&](std::size_t edge) {
      return std::abs(ball(plan_.other_end(edge, node)).radius - ball(node).radius) <
             plan_.length(edge);
    });
  }

  [[nodiscard]] std::vector<std::size_t> by_length(std::size_t node) const {
    std::vector<std::size_t> result = plan_.nodes()[node].edges;
    std::ranges::stable_sort(result, {}, [&](std::size_t edge) { return plan_.length(edge); });
    return result;
  }

  // Whether the nodes have a neighbour in common, so that to merge them would close a hole.
  [[nodiscard]] bool is_in_triangle(std::size_t node, std::size_t other) const {
    const std::set<std::size_t> here = neighbours(node), there = neighbours(other);
    return std::ranges::any_of(here, [&](std::size_t one) { return there.contains(one); });
  }

  // A short edge vanishes, and the node of lower degree with it.
  bool contract(std::size_t node, double reach, const Misfit& why, int depth) {
    for (const std::size_t edge : by_length(node)) {
      const std::size_t other = plan_.other_end(edge, node);
      if (plan_.length(edge) > reach * (ball(node).radius + ball(other).radius)) {
        return false;
      }
      const bool is_all = degree(node) == 1 && degree(other) == 1;
      if (!is_in_triangle(node, other) && !is_all &&
          (degree(other) > degree(node) ? merge(node, other, edge, why, depth)
                                        : merge(other, node, edge, why, depth))) {
        return true;
      }
    }
    return false;
  }

  bool merge(std::size_t gone, std::size_t kept, std::size_t edge, const Misfit& why, int depth) {
    const Mark before = mark();
    const std::vector<std::size_t> again = merged(gone, kept, edge, why);
    if (has_cones(kept) &&
        (fits(kept, depth) || (depth > 0 && contract(kept, kOverlapping, why, depth - 1))) &&
        plan_again(again)) {
      return true;
    }
    take_back(before);
    return false;
  }

  // Into the node that is kept; what has to be planned again but for it.
  std::vector<std::size_t> merged(std::size_t gone, std::size_t kept, std::size_t edge,
                                  const Misfit& why) {
    const double length = plan_.length(edge);
    const std::string name = plan_.edge_name(edge);
    save({gone, kept});
    std::set<std::size_t> turned = neighbours(gone);
    turned.erase(kept);
    std::vector<std::size_t> again = unplanned(turned);
    unplanned({gone, kept});
    plan_.remove_edge(edge);
    for (const std::size_t other : std::vector(plan_.nodes()[gone].edges)) {
      plan_.lead_to(other, gone, kept);
    }
    plan_.remove_node(gone);
    reasons_.emplace_back(notes_.size(), why);
    notes_.push_back(
        {ball(gone).line, "edge " + name + ": of length " + decimal(length, kMessageDigits) +
                              ", too short for what its nodes need, contracted: node " +
                              ball(gone).name + " merged with node " + ball(kept).name});
    return again;
  }

  // Edges that are too short go on to the next nodes but one, past bends, until none is.
  bool stretch(std::size_t node, const Misfit& why) {
    constexpr int kMost = 24;
    const Mark before = mark();
    std::set<std::size_t> again;
    for (int i = 0; i < kMost && has_cones(node); ++i) {
      if (plan_.plan(node)) {
        if (plan_again(std::vector(again.begin(), again.end()))) {
          return true;
        }
        break;
      }
      const std::vector<std::size_t> edges = plan_.why_not().too_short();
      const auto edge = std::ranges::find_if(edges, [&](std::size_t one) {
        const std::size_t other = plan_.other_end(one, node);
        return degree(other) == 2 &&
               plan_.length(one) <= kLong * (ball(node).radius + ball(other).radius) &&
               !is_in_triangle(node, other);
      });
      if (edge == edges.end()) {
        break;
      }
      const std::size_t other = plan_.other_end(*edge, node);
      for (const std::size_t one : merged(other, node, *edge, why)) {
        again.insert(one);
      }
      again.erase(other);
    }
    take_back(before);
    return false;
  }

  // Edges whose directions lie close together get a hub of their own.
  bool split(std::size_t node, const Misfit& why, int depth) {
    if (degree(node) < 3) {
      return false;
    }
    const std::vector<std::size_t> order = by_nearness(node);
    // What builds on other changes gets fewer trials, as these multiply.
    const bool is_first = depth == kDepth;
    const std::size_t most = is_first ? order.size() : std::min<std::size_t>(order.size(), 4);
    for (std::size_t count = 2; count < most; ++count) {
      const std::vector<std::size_t> some(order.begin(), order.begin() + std::ptrdiff_t(count));
      for (const double distance : std::span(kHubDistances).first(is_first ? 4 : 2)) {
        if (split_off(node, some, distance, why, depth)) {
          return true;
        }
      }
    }
    return false;
  }

  [[nodiscard]] Vec3 direction(std::size_t edge, std::size_t node) const {
    return (ball(plan_.other_end(edge, node)).center - ball(node).center).normalized();
  }

  // The two edges that are closest to each other, then always the one that is closest to these.
  [[nodiscard]] std::vector<std::size_t> by_nearness(std::size_t node) const {
    std::vector<std::size_t> left = plan_.nodes()[node].edges, result;
    const auto angle = [&](std::size_t one, std::size_t other) {
      return numbers::angle_between(direction(one, node), direction(other, node));
    };
    std::array<std::size_t, 2> closest{left[0], left[1]};
    for (const std::size_t one : left) {
      for (const std::size_t other : left) {
        if (one < other && angle(one, other) < angle(closest[0], closest[1])) {
          closest = {one, other};
        }
      }
    }
    result.assign(closest.begin(), closest.end());
    std::erase_if(left, [&](std::size_t edge) { return std::ranges::count(closest, edge) > 0; });
    while (!left.empty()) {
      const auto gap = [&](std::size_t edge) {
        double least = angle(edge, result.front());
        for (const std::size_t one : result) {
          least = std::min(least, angle(edge, one));
        }
        return least;
      };
      const auto next = std::ranges::min_element(left, {}, gap);
      result.push_back(*next);
      left.erase(next);
    }
    return result;
  }

  bool split_off(std::size_t node, const std::vector<std::size_t>& some, double distance,
                 const Misfit& why, int depth) {
    Vec3 sum = Vec3::Zero();
    double shortest = plan_.length(some.front()), radius = 0;
    for (const std::size_t edge : some) {
      sum += direction(edge, node);
      shortest = std::min(shortest, plan_.length(edge));
    }
    if (!(sum.norm() > 0.5)) {
      return false;
    }
    const double out = distance * shortest;
    for (const std::size_t edge : some) {
      radius += plan_.ring(edge, node, out).radius / double(some.size());
    }
    const Mark before = mark();
    save({node});
    std::set<std::size_t> turned;
    for (const std::size_t edge : some) {
      turned.insert(plan_.other_end(edge, node));
    }
    const std::vector<std::size_t> again = unplanned(turned);
    unplanned({node});
    const std::size_t hub = plan_.add_node(
        {name_of_hub(node), ball(node).center + out * sum.normalized(), radius, ball(node).line});
    plan_.add_edge({node, hub, ball(node).line});
    for (const std::size_t edge : some) {
      plan_.lead_to(edge, node, hub);
    }
    note(node, split_text(hub, some), why);
    if (has_cones(hub) && fits(hub, depth - 1) && fits(node, depth - 1) && plan_again(again) &&
        are_apart(node, hub)) {
      return true;
    }
    take_back(before);
    return false;
  }

  [[nodiscard]] std::string name_of_hub(std::size_t node) const {
    const std::string base = ball(node).name.substr(0, ball(node).name.find('+'));
    const auto others = std::ranges::count_if(
        plan_.nodes().begin() + std::ptrdiff_t(given_), plan_.nodes().end(),
        [&](const PlannedNode& one) { return one.ball.name.starts_with(base + "+"); });
    return base + "+" + std::to_string(others + 1);
  }

  [[nodiscard]] std::string split_text(std::size_t hub,
                                       const std::vector<std::size_t>& some) const {
    std::string names;
    for (const std::size_t edge : some) {
      names += (names.empty() ? "" : ", ") + ball(plan_.other_end(edge, hub)).name;
    }
    return "its edges to " + names + " led to a hub of their own, " + ball(hub).name;
  }

  // Whether what leaves the one passes through nothing that leaves the other.
  [[nodiscard]] bool are_apart(std::size_t node, std::size_t hub) const {
    return std::ranges::none_of(plan_.nodes()[node].edges, [&](std::size_t one) {
      return std::ranges::any_of(plan_.nodes()[hub].edges,
                                 [&](std::size_t other) { return pass(plan_, one, other); });
    });
  }

  // With less and less of the node's radius.
  bool narrow(std::size_t node, const Misfit& why) {
    const double before = ball(node).radius;
    for (const double share : {0.85, 0.7, 0.55, 0.4}) {
      const Mark here = mark();
      save({node});
      const std::vector<std::size_t> again = unplanned(neighbours(node));
      plan_.set_radius(node, share * before);
      note(node,
           "its radius of " + decimal(before, kMessageDigits) + " made " +
               decimal(share * before, kMessageDigits),
           why);
      if (has_cones(node) && fits(node, 1) && plan_again(again)) {
        return true;
      }
      take_back(here);
    }
    return false;
  }

  GraphPlan& plan_;
  const std::map<std::string, std::string>& refused_;
  std::vector<SourceNote>& notes_;
  std::vector<std::pair<std::size_t, Misfit>> reasons_;  // of notes, not told yet
  std::size_t given_;
  std::vector<GraphPlan::Snapshot> undo_;
};

}  // namespace

void plan_all(GraphPlan& plan, const std::map<std::string, std::string>& refused,
              std::vector<SourceNote>& notes) {
  Planner(plan, refused, notes).run();
}

}  // namespace dupin::network
