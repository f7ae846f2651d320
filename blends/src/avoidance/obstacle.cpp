#include "avoidance/obstacle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "numbers/interval.h"
#include "ringed/nearest_in_disc.h"
#include "surfaces/surface_piece.h"

namespace dupin::avoidance {
namespace {

using numbers::Interval;

// The capsule about the segment from the first control point to the last that holds all discs.
Obstacle capsule_about(const surfaces::DiscHull& hull) {
  const Vec3 from = middle(hull.centers.front()), to = middle(hull.centers.back());
  const Vec3 along = to - from;
  Obstacle result{from, {along}, 0};
  Interval farthest = 0;
  for (const numbers::IntervalVec& center : hull.centers) {
    // From any point of the segment: the hull of the centres is convex, and so is the distance.
    const double squared = along.squaredNorm();
    const double s =
        squared > 0 ? std::clamp(along.dot(middle(center) - from) / squared, 0.0, 1.0) : 0.0;
    const numbers::IntervalVec on =
        numbers::interval_vec(from) + Interval(s) * numbers::interval_vec(along);
    const numbers::IntervalVec off = center - on;
    farthest = max(farthest, sqrt(numbers::dot(off, off)));
  }
  result.radius = (farthest + hull.radius).upper;
  return result;
}

}  // namespace

std::vector<NamedObstacle> obstacles_of(const std::string& part, const PartSurface& surface) {
  if (const auto* ball = std::get_if<Sphere>(&surface)) {
    return {{part, {ball->center, {}, ball->radius}}};
  }
  constexpr int kStretches = 16;
  std::vector<NamedObstacle> result;
  for (const Piece& piece : std::get<Chain>(surface).pieces) {
    const auto* ringed = std::get_if<RingedSurface>(&piece);
    const bool is_pipe = ringed != nullptr && std::holds_alternative<LineSpine>(ringed->spine) &&
                         std::holds_alternative<ConstantRadius>(ringed->radius);
    const int count = is_pipe ? 1 : kStretches;
    const surfaces::PieceDiscs discs =
        std::visit([](const auto& one) { return surfaces::discs(one); }, piece);
    for (int i = 0; i < count; ++i) {
      result.push_back(
          {part, capsule_about(discs.hull({double(i) / count, double(i + 1) / count}))});
    }
  }
  return result;
}

// Coordinate descent on the edges' fractions, exact for right angles.
Vec3 nearest_core_point(const Obstacle& obstacle, const Vec3& point) {
  constexpr int kSweeps = 24;
  Vec3 result = obstacle.corner;
  std::vector<double> fractions(obstacle.edges.size(), 0);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t i = 0; i < fractions.size(); ++i) {
      const Vec3& edge = obstacle.edges[i];
      const double squared = edge.squaredNorm();
      if (squared > 0) {
        const double before = fractions[i];
        fractions[i] = std::clamp(before + edge.dot(point - result) / squared, 0.0, 1.0);
        result += (fractions[i] - before) * edge;
      }
    }
    if (fractions.size() < 2) {
      break;
    }
  }
  return result;
}

// Alternating projections between two convex sets.
Approach approach(const TravelRing& disc, const Obstacle& obstacle) {
  constexpr int kSteps = 40;
  Vec3 on_disc = disc.center, on_core = nearest_core_point(obstacle, on_disc);
  for (int i = 0; i < kSteps; ++i) {
    const Vec3 next = ringed::nearest_in_disc(disc, on_core);
    const bool is_done = next == on_disc;
    on_disc = next;
    on_core = nearest_core_point(obstacle, on_disc);
    if (is_done) {
      break;
    }
  }
  return {(on_core - on_disc).norm() - obstacle.radius, on_disc, on_core - on_disc};
}

double separation(const surfaces::DiscHull& discs, const Obstacle& obstacle,
                  const Vec3& direction) {
  if (!(direction.norm() > 0)) {
    return -std::numeric_limits<double>::infinity();
  }
  const Vec3 u = direction.normalized();
  const numbers::IntervalVec exact = numbers::interval_vec(u);
  Interval least = numbers::dot(exact, numbers::interval_vec(obstacle.corner));
  for (const Vec3& edge : obstacle.edges) {
    least = least + min(Interval(0), numbers::dot(exact, numbers::interval_vec(edge)));
  }
  const Interval gap = least - Interval(surfaces::support(discs, u));
  return (gap / sqrt(numbers::dot(exact, exact)) - Interval(obstacle.radius)).lower;
}

}  // namespace dupin::avoidance
