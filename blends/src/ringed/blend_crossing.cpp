#include "ringed/blend_crossing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

namespace dupin::ringed {
namespace {

constexpr double kSpacing = 1. / 8;  // of discs, in radii
constexpr int kMost = 1500;          // discs

struct Disc {
  Vec3 center, normal;
  double radius = 0;
  double way = 0;      // along the spine
  double spacing = 0;  // to its neighbours
};

// Along the line that their planes share.
bool meet(const Disc& a, const Disc& b) {
  const Vec3 line = a.normal.cross(b.normal), way = b.center - a.center;
  const double turn = line.norm();
  const auto half_chord = [turn](const Disc& disc, double offset) {
    return std::sqrt(disc.radius * disc.radius - offset * offset / (turn * turn));
  };
  const double chords = half_chord(a, b.normal.dot(way)) + half_chord(b, a.normal.dot(way));
  return std::abs(line.dot(way)) <= turn * chords;  // false for what is no number
}

// Side by side, where the planes are nearly parallel and the discs between the samples would meet.
// A spine that turns no faster than the radius allows is further ahead after four samples, or
// further aside after half a turn.
bool are_side_by_side(const Disc& a, const Disc& b) {
  constexpr double kParallel = 0.97, kAside = 0.99;
  const double spacing = std::max(a.spacing, b.spacing);
  if (std::abs(b.way - a.way) < 4 * spacing || std::abs(a.normal.dot(b.normal)) < kParallel) {
    return false;
  }
  const Vec3 off = b.center - a.center;
  const double ahead = a.normal.dot(off);
  return std::abs(ahead) <= spacing &&
         (off - ahead * a.normal).norm() <= kAside * (a.radius + b.radius);
}

bool overlap(const Disc& a, const Disc& b) {
  const double reach = a.radius + b.radius;
  return (b.center - a.center).squaredNorm() <= reach * reach &&
         (meet(a, b) || are_side_by_side(a, b));
}

std::vector<Disc> discs_of(const RingedSurface& blend, double thicker) {
  const double whole = length(blend.spine);
  constexpr int kFine = 8 * kMost;
  std::vector<Disc> result;
  Vec3 last = blend.start.center;
  double way = 0;
  for (int i = 0; i <= kFine; ++i) {
    const double t = double(i) / kFine;
    const SpinePoint point = evaluate(blend.spine, t);
    way += (point.position - last).norm();
    last = point.position;
    const double radius = thicker * evaluate(blend.radius, t).value;
    const double spacing = std::max(kSpacing * radius, whole / kMost);
    if (result.empty() || i == kFine || way - result.back().way >= spacing) {
      result.push_back({point.position, point.first.normalized(), radius, way, spacing});
    }
  }
  return result;
}

// Of the cylinder or cone that a ring ends, as far behind it as the blend reaches. `way` is the
// blend's there, and `sign` how it goes on behind.
std::vector<Disc> discs_behind(const Ring& ring, const std::vector<Disc>& blend, double sign) {
  double farthest = 0;
  for (const Disc& disc : blend) {
    farthest = std::max(farthest, (disc.center - ring.center).dot(ring.normal) + disc.radius);
  }
  const double way = sign < 0 ? 0 : blend.back().way, first = largest_radius(ring);
  const double slope = std::max(ring.slope, across_slope(ring));
  std::vector<Disc> result;
  double behind = 0, radius = first;
  while (behind < farthest && radius > first / 8 && result.size() < kMost) {
    const double spacing = std::max(kSpacing * radius, farthest / kMost);
    behind += spacing;
    radius = first + slope * behind;
    result.push_back(
        {ring.center + behind * ring.normal, ring.normal, radius, way + sign * behind, spacing});
  }
  return result;
}

bool crosses_itself(const std::vector<Disc>& discs) {
  for (auto disc = discs.begin(); disc != discs.end(); ++disc) {
    if (std::any_of(discs.begin(), disc,
                    [&](const Disc& other) { return overlap(other, *disc); })) {
      return true;
    }
  }
  return false;
}

bool cross(const std::vector<Disc>& blend, const std::vector<Disc>& behind) {
  return std::ranges::any_of(blend, [&](const Disc& disc) {
    return std::ranges::any_of(behind, [&](const Disc& other) { return overlap(disc, other); });
  });
}

}  // namespace

std::optional<std::string> crossing(const RingedSurface& blend, double margin) {
  const std::vector<Disc> discs = discs_of(blend, 1 + margin / 2);
  if (crosses_itself(discs)) {
    return std::string(kCrossesItself);
  }
  if (cross(discs, discs_behind(blend.start, discs, -1))) {
    return "runs into what would go straight on behind its start";
  }
  if (cross(discs, discs_behind(blend.end, discs, 1))) {
    return "runs into what would go straight on behind its end";
  }
  return std::nullopt;
}

}  // namespace dupin::ringed
