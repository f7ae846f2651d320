#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <tuple>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/gap.h"
#include "gaps/port_tree.h"

namespace dupin {
namespace {

using gaps::compare_distances;
using gaps::PortTree;

void validate(std::span<const Port> ports, double connect) {
  if (!std::isfinite(connect) || connect < 0) {
    throw Error(Errc::invalid_argument,
                "the distance within which ends are connected must be a finite length of at least "
                "0, not " +
                    decimal(connect));
  }
  for (const Port& port : ports) {
    try {
      dupin::validate(port.ring);
    } catch (const Error& error) {
      throw error.in_part(port.name);
    }
  }
}

std::vector<std::uint32_t> ordered_by_name(std::span<const Port> ports) {
  std::vector<std::uint32_t> order(ports.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return ports[a].name < ports[b].name; });
  return order;
}

std::vector<std::uint32_t> inverse(const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> rank(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    rank[order[i]] = i;
  }
  return rank;
}

class Pairing {
 public:
  explicit Pairing(std::span<const Port> ports)
      : ports_(ports), by_name_(ordered_by_name(ports)), tree_(ports, inverse(by_name_)) {}

  void join_welded();
  void join_nearest(double connect);
  [[nodiscard]] std::vector<GapPair> finish();

 private:
  struct Candidate {
    std::uint32_t first, second;
  };
  void join(std::uint32_t a, std::uint32_t b);
  void join_within(std::span<const std::uint32_t> group);
  [[nodiscard]] bool later(const Candidate& a, const Candidate& b) const;

  std::span<const Port> ports_;
  std::vector<std::uint32_t> by_name_;
  PortTree tree_;
  std::vector<GapPair> pairs_;
};

void Pairing::join(std::uint32_t a, std::uint32_t b) {
  tree_.remove(a);
  tree_.remove(b);
  const auto [first, second] = std::minmax(a, b);
  pairs_.push_back({first, second, measure_gap(ports_[first].ring, ports_[second].ring)});
}

// Rings on the same curve are neighbours in this order: it does not see which way they face.
auto curve_key(const Ring& ring) {
  const Vec3 other = -ring.normal;
  const auto triple = [](const Vec3& v) { return std::tuple(v.x(), v.y(), v.z()); };
  return std::tuple(triple(ring.center), ring.radius, across(ring),
                    std::max(triple(ring.normal), triple(other)));
}

void Pairing::join_welded() {
  std::vector<std::uint32_t> order = by_name_;
  const auto key = [&](std::uint32_t port) { return curve_key(ports_[port].ring); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (auto from = order.begin(); from != order.end();) {
    const auto to = std::find_if(from, order.end(),
                                 [&](std::uint32_t port) { return key(port) != key(*from); });
    join_within({from, to});
    from = to;
  }
}

void Pairing::join_within(std::span<const std::uint32_t> group) {
  for (std::size_t i = 0; i < group.size(); ++i) {
    for (std::size_t j = i + 1; j < group.size() && tree_.holds(group[i]); ++j) {
      const bool opposed = ports_[group[i]].ring.normal != ports_[group[j]].ring.normal;
      if (opposed && tree_.holds(group[j]) && tree_.may_pair(group[i], group[j])) {
        join(group[i], group[j]);
      }
    }
  }
}

bool Pairing::later(const Candidate& a, const Candidate& b) const {
  const auto center = [&](std::uint32_t port) -> const Vec3& { return ports_[port].ring.center; };
  const int order =
      gaps::compare_distances(center(a.first), center(a.second), center(b.first), center(b.second));
  const auto ranks = [&](const Candidate& c) {
    return std::minmax({tree_.rank(c.first), tree_.rank(c.second)});
  };
  return order != 0 ? order > 0 : ranks(a) > ranks(b);
}

// Every port that is left waits with its nearest one. The least of these pairs is the least of all
// pairs, and so mutually nearest; a port that comes first but whose partner is gone looks again.
void Pairing::join_nearest(double connect) {
  const auto order = [this](const Candidate& a, const Candidate& b) { return later(a, b); };
  std::priority_queue<Candidate, std::vector<Candidate>, decltype(order)> queue(order);
  const auto look = [&](std::uint32_t port) {
    if (const auto partner = tree_.nearest(port, connect)) {
      queue.push({port, *partner});
    }
  };
  for (const std::uint32_t port : by_name_) {
    if (tree_.holds(port)) {
      look(port);
    }
  }
  while (!queue.empty()) {
    const Candidate least = queue.top();
    queue.pop();
    if (tree_.holds(least.first) && tree_.holds(least.second)) {
      join(least.first, least.second);
    } else if (tree_.holds(least.first)) {
      look(least.first);
    }
  }
}

std::vector<GapPair> Pairing::finish() {
  for (std::uint32_t port = 0; port < ports_.size(); ++port) {
    if (tree_.holds(port)) {
      pairs_.push_back({port, std::nullopt, {}});
    }
  }
  std::sort(pairs_.begin(), pairs_.end(),
            [](const GapPair& a, const GapPair& b) { return a.first < b.first; });
  return std::move(pairs_);
}

}  // namespace

std::vector<GapPair> pair_ends(std::span<const Port> ports, double connect) {
  validate(ports, connect);
  Pairing pairing(ports);
  pairing.join_welded();
  pairing.join_nearest(connect);
  return pairing.finish();
}

}  // namespace dupin
