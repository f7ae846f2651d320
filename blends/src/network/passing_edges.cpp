#include "network/passing_edges.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace dupin::network {
namespace {

// What is left of an edge when it is cut back: balls about p + t d of the radius r + t rise.
struct Span {
  Vec3 from, along;
  double radius, rise;

  [[nodiscard]] Vec3 at(double t) const { return from + t * along; }
  [[nodiscard]] double radius_at(double t) const { return radius + t * rise; }
  [[nodiscard]] double low() const { return std::min(from.x() - radius, at(1).x() - radius_at(1)); }
  [[nodiscard]] double high() const {
    return std::max(from.x() + radius, at(1).x() + radius_at(1));
  }
};

// From one radius within its ends, as balls reach beyond them.
Span span_of(const GraphPlan& plan, std::size_t edge) {
  const PlannedEdge& planned = plan.edges()[edge];
  const double half = plan.length(edge) / 2;
  const auto end = [&](std::size_t node, double setback) {
    const double radius = plan.nodes()[node].ball.radius;
    const bool is_free = plan.nodes()[node].edges.size() == 1;
    return plan.ring(edge, node, is_free ? 0 : std::min(setback + radius, half));
  };
  const Ring from = end(planned.ends.from, planned.setbacks[0]),
             to = end(planned.ends.to, planned.setbacks[1]);
  return {from.center, to.center - from.center, from.radius, to.radius - from.radius};
}

// A convex function's least value on [0, 1], nearly.
template <class Function>
double least(const Function& f) {
  constexpr double kGolden = 0.618033988749895;
  constexpr int kSteps = 30;
  double a = 0, b = 1, c = 1 - kGolden, d = kGolden, fc = f(c), fd = f(d);
  for (int i = 0; i < kSteps; ++i) {
    if (fc < fd) {
      b = d, d = c, fd = fc, c = b - kGolden * (b - a), fc = f(c);
    } else {
      a = c, c = d, fc = fd, d = a + kGolden * (b - a), fd = f(d);
    }
  }
  return std::min({fc, fd, f(0.0), f(1.0)});
}

// Of two segments.
double distance(const Span& one, const Span& other) {
  const Vec3 r = one.from - other.from;
  const Vec3 &d = one.along, &e = other.along;
  const double dd = d.squaredNorm(), ee = e.squaredNorm(), de = d.dot(e), rd = r.dot(d),
               re = r.dot(e);
  const double denominator = dd * ee - de * de;
  double s = denominator > 0 ? std::clamp((de * re - rd * ee) / denominator, 0.0, 1.0) : 0;
  const double t = ee > 0 ? std::clamp((de * s + re) / ee, 0.0, 1.0) : 0;
  s = dd > 0 ? std::clamp((de * t - rd) / dd, 0.0, 1.0) : 0;
  return (r + s * d - t * e).norm();
}

bool pass(const Span& one, const Span& other) {
  const double thickest =
      std::max(one.radius, one.radius_at(1)) + std::max(other.radius, other.radius_at(1));
  if (distance(one, other) > thickest) {
    return false;
  }
  return least([&](double s) {
           const Vec3 p = one.at(s);
           return least([&](double t) { return (p - other.at(t)).norm() - other.radius_at(t); }) -
                  one.radius_at(s);
         }) <= 0;
}

bool share_node(const GraphEdge& a, const GraphEdge& b) {
  return a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to;
}

// A part of an edge, or of what a node became: a hub, or an arm along an edge.
struct Piece {
  Span span;
  std::optional<std::size_t> node = {}, edge = {};
};

std::vector<Piece> edge_pieces(const GraphPlan& plan) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < plan.edges().size(); ++i) {
    if (plan.edges()[i].is_left) {
      pieces.push_back({span_of(plan, i), {}, i});
    }
  }
  return pieces;
}

// Calls visit(a, b) for all pieces that overlap along x.
template <class Visit>
void for_each_overlap(std::vector<Piece> pieces, const Visit& visit) {
  std::ranges::stable_sort(pieces, {}, [](const Piece& piece) { return piece.span.low(); });
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const double high = pieces[k].span.high();
    for (std::size_t l = k + 1; l < pieces.size() && pieces[l].span.low() <= high; ++l) {
      visit(pieces[k], pieces[l]);
    }
  }
}

// The arc between the rings of a blend's edges, as so many chords.
constexpr int kChords = 4;

void add_bend(const GraphPlan& plan, std::size_t node, std::vector<Piece>& pieces) {
  const auto& edges = plan.nodes()[node].edges;
  const auto end = [&](std::size_t edge) {
    const PlannedEdge& planned = plan.edges()[edge];
    return plan.ring(edge, node, planned.setbacks[planned.ends.from == node ? 0 : 1]);
  };
  const Ring a = end(edges[0]), b = end(edges[1]);
  const Vec3& corner = plan.nodes()[node].ball.center;
  const double weight = (a.normal - b.normal).norm() / 2;  // the cosine of half the turn
  const auto at = [&](double t) {
    const double u = (1 - t) * (1 - t), v = 2 * weight * t * (1 - t), w = t * t;
    return Vec3((u * a.center + v * corner + w * b.center) / (u + v + w));
  };
  for (int i = 0; i < kChords; ++i) {
    const double t = double(i) / kChords, next = double(i + 1) / kChords;
    const double step = (b.radius - a.radius) / kChords;
    pieces.push_back({{at(t), at(next) - at(t), a.radius + i * step, step}, node, {}});
  }
}

void add_node_pieces(const GraphPlan& plan, std::size_t node, std::vector<Piece>& pieces) {
  const PlannedNode& planned = plan.nodes()[node];
  const Vec3& center = planned.ball.center;
  if (planned.kind == NodeKind::ball) {
    pieces.push_back({{center, Vec3::Zero(), kBall * planned.ball.radius, 0}, node, {}});
  } else if (planned.kind == NodeKind::blend) {
    add_bend(plan, node, pieces);
  } else if (planned.kind == NodeKind::junction) {
    pieces.push_back({{center, Vec3::Zero(), planned.hub, 0}, node, {}});
    for (const std::size_t edge : planned.edges) {
      const PlannedEdge& ends = plan.edges()[edge];
      const Ring ring = plan.ring(edge, node, ends.setbacks[ends.ends.from == node ? 0 : 1]);
      pieces.push_back({{ring.center, center - ring.center, ring.radius, 0}, node, edge});
    }
  }
}

bool is_incident(const GraphPlan& plan, std::size_t edge, std::size_t node) {
  return plan.edges()[edge].ends.from == node || plan.edges()[edge].ends.to == node;
}

// Whether the pieces meet as they should, one of which is a node's.
bool are_joined(const GraphPlan& plan, const Piece& a, const Piece& b) {
  if (!a.node || !b.node) {
    return is_incident(plan, a.node ? *b.edge : *a.edge, a.node ? *a.node : *b.node);
  }
  const auto& edges = plan.nodes()[*a.node].edges;
  const auto between = std::ranges::find_if(
      edges, [&](std::size_t edge) { return plan.other_end(edge, *a.node) == *b.node; });
  return *a.node == *b.node || (between != edges.end() &&
                                ((!a.edge && !b.edge) || a.edge == *between || b.edge == *between));
}

}  // namespace

bool pass(const GraphPlan& plan, std::size_t one, std::size_t other) {
  return !share_node(plan.edges()[one].ends, plan.edges()[other].ends) &&
         pass(span_of(plan, one), span_of(plan, other));
}

std::vector<std::array<std::size_t, 2>> passing_edges(const GraphPlan& plan) {
  std::vector<std::array<std::size_t, 2>> result;
  for_each_overlap(edge_pieces(plan), [&](const Piece& a, const Piece& b) {
    const auto [one, other] = std::minmax(*a.edge, *b.edge);
    if (!share_node(plan.edges()[one].ends, plan.edges()[other].ends) && pass(a.span, b.span)) {
      result.push_back({one, other});
    }
  });
  std::ranges::sort(result);
  return result;
}

std::vector<PassingNode> passing_nodes(const GraphPlan& plan) {
  std::vector<Piece> pieces = edge_pieces(plan);
  for (std::size_t node = 0; node < plan.nodes().size(); ++node) {
    add_node_pieces(plan, node, pieces);
  }
  std::set<PassingNode> result;
  for_each_overlap(std::move(pieces), [&](const Piece& a, const Piece& b) {
    if ((!a.node && !b.node) || are_joined(plan, a, b) || !pass(a.span, b.span)) {
      return;
    }
    if (a.node && b.node) {
      result.insert({std::min(*a.node, *b.node), {}, std::max(*a.node, *b.node)});
    } else {
      result.insert({a.node ? *a.node : *b.node, a.node ? b.edge : a.edge, 0});
    }
  });
  return {result.begin(), result.end()};
}

}  // namespace dupin::network
