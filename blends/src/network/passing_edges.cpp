#include "network/passing_edges.h"

#include <algorithm>
#include <numeric>

namespace dupin::network {
namespace {

// Of two segments p + s d and q + t e, s and t in [0, 1].
double distance(const Vec3& p, const Vec3& d, const Vec3& q, const Vec3& e) {
  const Vec3 r = p - q;
  const double dd = d.squaredNorm(), ee = e.squaredNorm(), de = d.dot(e), rd = r.dot(d),
               re = r.dot(e);
  const double denominator = dd * ee - de * de;
  double s = denominator > 0 ? std::clamp((de * re - rd * ee) / denominator, 0.0, 1.0) : 0;
  const double t = std::clamp((de * s + re) / ee, 0.0, 1.0);
  s = std::clamp((de * t - rd) / dd, 0.0, 1.0);
  return (r + s * d - t * e).norm();
}

}  // namespace

std::vector<bool> passing_edges(const CleanGraph& graph) {
  const auto ends = [&](std::size_t i) {
    const GraphEdge& edge = graph.edges[i];
    return std::pair(graph.nodes[edge.from], graph.nodes[edge.to]);
  };
  struct Span {
    double low, high;
    Vec3 from, along;
    double radius;
  };
  std::vector<Span> spans;
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const auto [a, b] = ends(i);
    const double radius = std::max(a.radius, b.radius);
    spans.push_back({std::min(a.center.x(), b.center.x()) - radius,
                     std::max(a.center.x(), b.center.x()) + radius, a.center, b.center - a.center,
                     radius});
  }
  std::vector<std::size_t> order(spans.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return spans[i].low; });
  std::vector<bool> result(spans.size(), false);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Span& one = spans[order[k]];
    const GraphEdge& first = graph.edges[order[k]];
    for (std::size_t l = k + 1; l < order.size() && spans[order[l]].low <= one.high; ++l) {
      const Span& other = spans[order[l]];
      const GraphEdge& second = graph.edges[order[l]];
      const bool is_adjacent = first.from == second.from || first.from == second.to ||
                               first.to == second.from || first.to == second.to;
      if (!is_adjacent &&
          distance(one.from, one.along, other.from, other.along) <= one.radius + other.radius) {
        result[order[k]] = result[order[l]] = true;
      }
    }
  }
  return result;
}

}  // namespace dupin::network
