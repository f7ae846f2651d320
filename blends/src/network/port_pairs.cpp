#include "network/port_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "numbers/angle.h"

namespace dupin::network {
namespace {

// Ends whose directions are less than 60 degrees apart look the same way.
constexpr double kSameWay = 0.5;
// Of a leg: ends that overlap by more than this look away from each other.
constexpr double kMostOverlap = 0.5;
// How finely directions are told apart when the best partner is looked for.
constexpr double kFacingSteps = 16;

// A plant has about one for each end.
constexpr std::size_t kMostCandidates = 2'000'000;

using Cell = std::array<std::int64_t, 3>;

struct Candidate {
  bool is_bridge;
  int facing;  ///< 0 is best
  bool is_step;
  double distance;
  std::size_t first, second;
  [[nodiscard]] auto key() const {
    return std::tuple(is_bridge, facing, is_step, distance, first, second);
  }
};

std::optional<Vec3> direction(const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  const double length = way.norm();
  return length > 0 ? std::optional<Vec3>(way / length) : std::nullopt;
}

// What an end looks away from; none: its component does not tell.
std::optional<Vec3> origin(const PipingComponent& component, std::size_t index) {
  if (component.center && component.shape != PipingShape::straight) {
    return component.center;
  }
  if (component.ports.size() == 2) {
    return component.ports[1 - index].center;
  }
  return std::nullopt;
}

bool look_away(const LinePort& a, const LinePort& b) {
  if (!a.outward || !b.outward) {
    return false;
  }
  const Vec3 gap = b.center - a.center;
  return -gap.dot(*a.outward) > kMostOverlap * a.leg || gap.dot(*b.outward) > kMostOverlap * b.leg;
}

std::optional<Candidate> candidate(const std::vector<LinePort>& ports, std::size_t first,
                                   std::size_t second, double snap, double reach) {
  const LinePort &a = ports[first], &b = ports[second];
  const double distance = (a.center - b.center).norm();
  const double cosine = a.outward && b.outward ? a.outward->dot(*b.outward) : -1;
  if (a.component == b.component || !(distance <= reach) || cosine > kSameWay) {
    return std::nullopt;
  }
  if (distance > snap && look_away(a, b)) {
    return std::nullopt;
  }
  return Candidate{distance > snap,
                   static_cast<int>(std::lround((1 + cosine) * kFacingSteps)),
                   a.radius && b.radius && *a.radius != *b.radius,
                   distance,
                   first,
                   second};
}

std::vector<Candidate> candidates(const std::vector<LinePort>& ports, double snap, double reach) {
  const double size = reach > 0 ? reach : 1;
  std::map<Cell, std::vector<std::size_t>> cells;
  std::vector<Candidate> result;
  std::size_t count = 0;
  for (std::size_t i = 0; i < ports.size(); ++i) {
    Cell own;
    for (int axis = 0; axis < 3; ++axis) {
      own[static_cast<std::size_t>(axis)] =
          static_cast<std::int64_t>(std::floor(ports[i].center[axis] / size));
    }
    for (std::int64_t step = 0; step < 27; ++step) {
      const Cell cell{own[0] + step % 3 - 1, own[1] + step / 3 % 3 - 1, own[2] + step / 9 - 1};
      const auto found = cells.find(cell);
      if (found == cells.end()) {
        continue;
      }
      for (const std::size_t j : found->second) {
        if (const auto pair = candidate(ports, j, i, snap, reach)) {
          result.push_back(*pair);
        }
        if (++count > kMostCandidates) {
          throw Error(Errc::limit_exceeded,
                      "more than " + std::to_string(kMostCandidates) +
                          " pairs of ends lie within " + decimal(reach, kMessageDigits) +
                          " of each other, as at line " + std::to_string(ports[i].line) +
                          "; a smaller snap or bridge length may do");
        }
      }
    }
    cells[own].push_back(i);
  }
  return result;
}

}  // namespace

std::vector<LinePort> line_ports(const PipingLine& line, const std::vector<bool>& is_left_out) {
  std::vector<LinePort> result;
  for (std::size_t i = 0; i < line.components.size(); ++i) {
    const PipingComponent& component = line.components[i];
    for (std::size_t k = 0; k < component.ports.size() && !is_left_out[i]; ++k) {
      const PipingPort& port = component.ports[k];
      const std::optional<Vec3> from = origin(component, k);
      const std::optional<Vec3> outward = from ? direction(*from, port.center) : std::nullopt;
      if (outward || component.shape != PipingShape::fitting) {
        result.push_back({i, k, port.center, outward, port.radius, port.line,
                          from ? (port.center - *from).norm() : 0});
      }
    }
  }
  return result;
}

std::vector<PortPair> paired(const std::vector<LinePort>& ports, double snap, double bridge) {
  std::vector<Candidate> all = candidates(ports, snap, std::max(snap, bridge));
  std::ranges::sort(all, {}, &Candidate::key);
  std::vector<bool> is_taken(ports.size(), false);
  std::vector<PortPair> result;
  for (const Candidate& pair : all) {
    if (!is_taken[pair.first] && !is_taken[pair.second]) {
      is_taken[pair.first] = is_taken[pair.second] = true;
      result.push_back({pair.first, pair.second, pair.distance});
    }
  }
  std::ranges::sort(result, {}, &PortPair::first);
  return result;
}

double kink(const LinePort& a, const LinePort& b) {
  if (!a.outward || !b.outward) {
    return 0;
  }
  return numbers::angle_between(*a.outward, -*b.outward);
}

}  // namespace dupin::network
