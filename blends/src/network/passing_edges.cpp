#include "network/passing_edges.h"

#include <algorithm>
#include <numeric>

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

}  // namespace

bool pass(const GraphPlan& plan, std::size_t one, std::size_t other) {
  return !share_node(plan.edges()[one].ends, plan.edges()[other].ends) &&
         pass(span_of(plan, one), span_of(plan, other));
}

std::vector<std::array<std::size_t, 2>> passing_edges(const GraphPlan& plan) {
  std::vector<std::size_t> order;
  std::vector<Span> spans(plan.edges().size());
  for (std::size_t i = 0; i < spans.size(); ++i) {
    if (plan.edges()[i].is_left) {
      order.push_back(i);
      spans[i] = span_of(plan, i);
    }
  }
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return spans[i].low(); });
  std::vector<std::array<std::size_t, 2>> result;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const double high = spans[order[k]].high();
    for (std::size_t l = k + 1; l < order.size() && spans[order[l]].low() <= high; ++l) {
      const auto [one, other] = std::minmax(order[k], order[l]);
      if (!share_node(plan.edges()[one].ends, plan.edges()[other].ends) &&
          pass(spans[one], spans[other])) {
        result.push_back({one, other});
      }
    }
  }
  std::ranges::sort(result);
  return result;
}

}  // namespace dupin::network
