#include "shading/swept_patch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dupin::shading {
namespace {

// Steps that are shorter are the last ones: they come near their aim faster than linearly.
constexpr double kFinest = 0x1p-30;
constexpr int kMostSteps = 100;
// A foot so far from the nearest point, by the section's size, is looked for again: there the
// normal differs by as little, times the curvature.
constexpr double kOff = 0x1p-22;
constexpr int kMostMoves = 8;

}  // namespace

SweptPatch::SweptPatch(SectionFamily family) : family_(std::move(family)) {
  double longest = 0;
  Section last;
  for (int i = 0; i <= kCells; ++i) {
    const Section here = family_.section(double(i) / kCells);
    normals_.push_back(here.normal);
    distances_.push_back(here.normal.dot(here.center));
    const double radius = std::max(here.along, here.across);
    box_.extend(here.center + Vec3::Constant(radius));
    box_.extend(here.center - Vec3::Constant(radius));
    if (i > 0) {
      longest = std::max(longest, (here.center - last.center).norm() +
                                      std::abs(radius - std::max(last.along, last.across)));
    }
    last = here;
  }
  // Between two sections the surface is no further from them than they are from each other.
  box_.min() -= Vec3::Constant(longest);
  box_.max() += Vec3::Constant(longest);
}

double SweptPatch::ahead(const Vec3& place, double t) const {
  const Section at = family_.section(t);
  return (place - at.center).dot(at.normal);
}

// By false position with the Illinois rule, from a cell at whose ends the place is ahead of the
// plane and behind it; roughly, by one step.
double SweptPatch::parameter(const Vec3& place, int cell, double before, double after,
                             bool roughly) const {
  double from = double(cell) / kCells, to = double(cell + 1) / kCells, last = from;
  int side = 0;
  for (int step = 0; step < kMostSteps; ++step) {
    const double t = std::clamp(from + (to - from) * before / (before - after), from, to);
    if (roughly || std::abs(t - last) < kFinest || to - from < kFinest) {
      return t;
    }
    const double here = ahead(place, t);
    if (here == 0) {
      return t;
    }
    last = t;
    if (here > 0) {
      from = t;
      before = here;
      after = side == 1 ? after / 2 : after;
      side = 1;
    } else {
      to = t;
      after = here;
      before = side == -1 ? before / 2 : before;
      side = -1;
    }
  }
  return last;
}

std::optional<SweptPatch::Point> SweptPatch::towards(const Vec3& place, double t,
                                                     bool is_beyond) const {
  const Section at = family_.section(t);
  const Vec3 away = place - at.center;
  const Vec3 direction = (away - away.dot(at.normal) * at.normal).normalized();
  Point result{Vec3::Zero(), family_.normal(t, direction), 0, at.radius(direction)};
  result.position = at.center + result.radius * direction;
  const Vec3 way = place - result.position;
  result.distance = is_beyond ? way.norm() : std::abs(way.dot(result.normal));
  const bool has_normal = direction.squaredNorm() > 0 && result.normal.squaredNorm() > 0;
  return has_normal && result.position.allFinite() ? std::optional(result) : std::nullopt;
}

std::optional<SweptPatch::Point> SweptPatch::nearest(const Vec3& place, bool roughly) const {
  std::optional<Point> result;
  const auto consider = [&](double t, bool is_beyond) {
    const std::optional<Point> point = towards(place, t, is_beyond);
    if (point && (!result || point->distance < result->distance)) {
      result = point;
    }
  };
  double before = normals_[0].dot(place) - distances_[0];
  if (before < 0) {
    consider(0, true);
  }
  for (int i = 0; i < kCells; ++i) {
    const auto next = std::size_t(i) + 1;
    const double after = normals_[next].dot(place) - distances_[next];
    if (before >= 0 && after < 0) {
      consider(parameter(place, i, before, after, roughly), false);
    }
    before = after;
  }
  if (before >= 0) {
    consider(1, true);
  }
  return result;
}

std::optional<Foot> SweptPatch::foot(const Vec3& place) const {
  std::optional<Point> point = nearest(place, false);
  for (int i = 0; point && i < kMostMoves; ++i) {
    // What is left of the way from the foot, along the surface.
    const Vec3 way = place - point->position;
    const Vec3 above = way.dot(point->normal) * point->normal;
    if ((way - above).norm() <= kOff * point->radius) {
      break;
    }
    point = nearest(place - above, false);
  }
  return point ? std::optional(Foot{(place - point->position).norm(), point->normal})
               : std::nullopt;
}

std::optional<Foot> SweptPatch::rough_foot(const Vec3& place) const {
  const std::optional<Point> point = nearest(place, true);
  return point ? std::optional(Foot{point->distance, point->normal}) : std::nullopt;
}

}  // namespace dupin::shading
