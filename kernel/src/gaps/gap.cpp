#include "dupin/kernel/gap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "exact/exact_numbers.h"
#include "gaps/port_tree.h"

namespace dupin {
namespace {

using exact::cross;
using exact::dot;
using exact::exact_vector;
using exact::ExactVector;
using exact::rational;
using gaps::compare_distances;
using gaps::Outlook;
using gaps::PortTree;

GapVerdict verdict_of(const GapReport& report, bool facing, bool same_normal) {
  if (!facing) {
    return GapVerdict::open;
  }
  if (const int side = sgn(report.axial_dot); side != 0) {
    return side > 0 ? GapVerdict::gap : GapVerdict::overlap;
  }
  if (report.radius_difference != 0 || report.across_difference != 0) {
    return GapVerdict::step;
  }
  if (report.turn_sine_squared != 0) {
    return GapVerdict::turn;
  }
  if (!same_normal) {
    return GapVerdict::kink;
  }
  return report.offset_squared != 0 ? GapVerdict::offset : GapVerdict::welded;
}

std::vector<Deviation> deviations_of(const GapReport& report, bool same_normal, bool elliptic) {
  std::vector<Deviation> all;
  const auto list = [&all](bool present, Deviation::Kind kind, const Enclosure& size) {
    if (present) {
      all.push_back({kind, size});
    }
  };
  list(report.axial_dot != 0, Deviation::Kind::axial, report.axial);
  list(report.radius_difference != 0, Deviation::Kind::radius, report.radius);
  list(elliptic && report.across_difference != 0, Deviation::Kind::across, report.across);
  list(report.turn_sine_squared != 0, Deviation::Kind::turn, report.turn);
  list(!same_normal, Deviation::Kind::kink, report.kink);
  list(report.offset_squared != 0, Deviation::Kind::offset, report.offset);
  const bool first = report.slope_difference != 0;
  list(first || report.across_slope_difference != 0, Deviation::Kind::slope,
       enclosure_of(first ? report.slope_difference : report.across_slope_difference));
  return all;
}

Enclosure signed_length(const mpq_class& scaled, const mpq_class& scale_squared) {
  const Enclosure length = root_of(scaled * scaled / scale_squared);
  return scaled < 0 ? -length : length;
}

// The rings' semi-axes and slopes, those of b in the order of the directions of a's that they are
// nearer to.
void compare_axes(const Ring& a, Ring b, GapReport& report) {
  if (a.ellipse && b.ellipse) {
    const ExactVector u = exact_vector(a.ellipse->axis), v = exact_vector(b.ellipse->axis),
                      turn = exact::cross(u, v);
    const mpq_class along = exact::rational(exact::dot(u, v)),
                    aside_squared = exact::rational(exact::dot(turn, turn));
    const bool exchanged = aside_squared > along * along;
    if (exchanged) {
      std::swap(b.radius, b.ellipse->across);
      std::swap(b.slope, b.ellipse->across_slope);
    }
    const mpq_class sine = exchanged ? along * along : aside_squared;
    const mpq_class cosine = exchanged ? aside_squared : along * along;
    report.turn_sine_squared = sine / exact::rational(exact::dot(u, u) * exact::dot(v, v));
    // tan(turn) = sqrt(sine / cosine)
    report.turn = angle_of(sine / cosine, 1);
  }
  report.radius_difference = mpq_class(b.radius) - mpq_class(a.radius);
  report.across_difference = mpq_class(across(b)) - mpq_class(across(a));
  report.slope_difference = mpq_class(a.slope) + mpq_class(b.slope);
  report.across_slope_difference = mpq_class(across_slope(a)) + mpq_class(across_slope(b));
  report.radius = enclosure_of(report.radius_difference);
  report.across = enclosure_of(report.across_difference);
}

void validate(std::span<const Port> ports, double connect) {
  if (!std::isfinite(connect) || connect < 0) {
    throw Error(Errc::invalid_argument,
                "the distance within which ends are connected must be a finite length of at least "
                "0, not " +
                    decimal(connect, kMessageDigits));
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
      : ports_(ports),
        by_name_(ordered_by_name(ports)),
        tree_(ports, inverse(by_name_)),
        partner_(ports.size()),
        is_second_(ports.size(), false) {}

  void join_welded();
  void join_nearest(double connect);
  /// Those that are left and do not face each other.
  void join_kinked(double connect, const LiesInPart& lies_in_part);
  [[nodiscard]] std::vector<GapPair> finish() const;

 private:
  struct Candidate {
    std::uint32_t first, second;
  };
  void join(std::uint32_t a, std::uint32_t b);
  void join_within(std::span<const std::uint32_t> group);
  template <class Nearest>
  void join_by(const Nearest& nearest);
  [[nodiscard]] bool later(const Candidate& a, const Candidate& b) const;

  std::span<const Port> ports_;
  std::vector<std::uint32_t> by_name_;
  PortTree tree_;
  std::vector<std::optional<std::uint32_t>> partner_;  // of the first of a pair
  std::vector<bool> is_second_;
};

void Pairing::join(std::uint32_t a, std::uint32_t b) {
  tree_.remove(a);
  tree_.remove(b);
  partner_[std::min(a, b)] = std::max(a, b);
  is_second_[std::max(a, b)] = true;
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
      compare_distances(center(a.first), center(a.second), center(b.first), center(b.second));
  const auto ranks = [&](const Candidate& c) {
    return std::minmax({tree_.rank(c.first), tree_.rank(c.second)});
  };
  return order != 0 ? order > 0 : ranks(a) > ranks(b);
}

// Every port that is left waits with its nearest one. The least of these pairs is the least of all
// pairs, and so mutually nearest; a port that comes first but whose partner is gone looks again.
template <class Nearest>
void Pairing::join_by(const Nearest& nearest) {
  const auto order = [this](const Candidate& a, const Candidate& b) { return later(a, b); };
  std::priority_queue<Candidate, std::vector<Candidate>, decltype(order)> queue(order);
  const auto look = [&](std::uint32_t port) {
    if (const auto partner = nearest(port)) {
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

void Pairing::join_nearest(double connect) {
  join_by([&](std::uint32_t port) { return tree_.nearest(port, connect); });
}

void Pairing::join_kinked(double connect, const LiesInPart& lies_in_part) {
  join_by([&](std::uint32_t port) -> std::optional<std::uint32_t> {
    while (tree_.holds(port)) {
      const auto partner = tree_.nearest(port, connect, Outlook::not_same_way);
      if (!partner || !lies_in_part) {
        return partner;
      }
      const bool is_in_part = lies_in_part(port, *partner);
      if (!is_in_part && !lies_in_part(*partner, port)) {
        return partner;
      }
      tree_.remove(is_in_part ? port : *partner);
    }
    return std::nullopt;
  });
}

std::vector<GapPair> Pairing::finish() const {
  std::vector<std::uint32_t> first;
  for (std::uint32_t port = 0; port < ports_.size(); ++port) {
    if (!is_second_[port]) {
      first.push_back(port);
    }
  }
  std::vector<GapPair> pairs(first.size());
  for_each_in_parallel(pairs.size(), [&](std::size_t i) {
    GapPair& pair = pairs[i];
    pair.first = first[i];
    if (partner_[first[i]]) {
      pair.second = *partner_[first[i]];
      pair.report = measure_gap(ports_[pair.first].ring, ports_[*pair.second].ring);
      if (pair.report.verdict == GapVerdict::open) {
        pair.report.verdict = GapVerdict::kink;
      }
    }
  });
  return pairs;
}

}  // namespace

std::string_view name(GapVerdict verdict) {
  constexpr std::array<std::string_view, 8> kNames = {"welded", "gap",  "overlap", "step",
                                                      "turn",   "kink", "offset",  "open"};
  return kNames.at(static_cast<std::size_t>(verdict));
}

std::string_view name(Deviation::Kind kind) {
  constexpr std::array<std::string_view, 7> kNames = {"axial", "radius", "across", "turn",
                                                      "kink",  "offset", "slope"};
  return kNames.at(static_cast<std::size_t>(kind));
}

GapReport measure_gap(const Ring& a, const Ring& b) {
  validate(a);
  validate(b);
  const ExactVector n = exact_vector(a.normal), m = exact_vector(b.normal);
  const ExactVector d = exact_vector(b.center) - exact_vector(a.center);
  const ExactVector across = exact::cross(d, n), turn = exact::cross(n, m);
  const mpq_class along = exact::rational(exact::dot(n, m)),
                  turn_squared = exact::rational(exact::dot(turn, turn));
  const mpq_class both_squared = exact::rational(exact::dot(n, n) * exact::dot(m, m));
  const bool same_normal = a.normal == -b.normal;

  GapReport report;
  report.axial_dot = exact::rational(exact::dot(d, n));
  report.normal_squared = exact::rational(exact::dot(n, n));
  report.offset_squared = exact::rational(exact::dot(across, across)) / report.normal_squared;
  report.distance_squared = exact::rational(exact::dot(d, d));
  compare_axes(a, b, report);
  report.kink_sine_squared = turn_squared / both_squared;
  report.kink_cosine_squared = along * along / both_squared;
  report.axial = signed_length(report.axial_dot, report.normal_squared);
  report.offset = root_of(report.offset_squared);
  report.kink = angle_of(turn_squared, -along);
  report.verdict = verdict_of(report, along < 0, same_normal);
  report.deviations = deviations_of(report, same_normal, a.ellipse || b.ellipse);
  return report;
}

std::vector<GapPair> pair_ends(std::span<const Port> ports, double connect,
                               const LiesInPart& lies_in_part) {
  validate(ports, connect);
  Pairing pairing(ports);
  pairing.join_welded();
  pairing.join_nearest(connect);
  pairing.join_kinked(connect, lies_in_part);
  return pairing.finish();
}

}  // namespace dupin
