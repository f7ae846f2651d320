#include "shading/swept_patch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dupin::shading {
namespace {

// Parameters that differ by less are the same: normals turn by a few times this.
constexpr double kFinest = 0x1p-40;
constexpr int kMostSteps = 100;
// A place so far from where it was looked for, by the section's size, is looked for again.
constexpr double kOff = 0x1p-30;
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
// plane and behind it.
double SweptPatch::parameter(const Vec3& place, int cell, double before, double after) const {
  double from = double(cell) / kCells, to = double(cell + 1) / kCells, last = from;
  int side = 0;
  for (int step = 0; step < kMostSteps; ++step) {
    const double t = std::clamp(from + (to - from) * before / (before - after), from, to);
    const double here = ahead(place, t);
    if (here == 0 || std::abs(t - last) < kFinest || to - from < kFinest) {
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

// `on` becomes the point of the section in the direction of the place.
std::optional<Foot> SweptPatch::foot_in(const Vec3& place, const Found& found, Vec3& on) const {
  const Section at = family_.section(found.t);
  const Vec3 away = place - at.center;
  const Vec3 direction = (away - away.dot(at.normal) * at.normal).normalized();
  on = at.center + at.radius(direction) * direction;
  const Vec3 normal = family_.normal(found.t, direction);
  if (!(direction.squaredNorm() > 0) || !(normal.squaredNorm() > 0) || !on.allFinite()) {
    return std::nullopt;
  }
  return Foot{found.beyond ? (place - on).norm() : std::abs((place - on).dot(normal)), normal};
}

std::optional<Foot> SweptPatch::nearest_in_section(const Vec3& place, Vec3& on) const {
  std::optional<Foot> nearest;
  const auto consider = [&](const Found& found) {
    Vec3 there;
    const std::optional<Foot> foot = foot_in(place, found, there);
    if (foot && (!nearest || foot->distance < nearest->distance)) {
      nearest = foot;
      on = there;
    }
  };
  double before = normals_[0].dot(place) - distances_[0];
  if (before < 0) {
    consider({0, true});
  }
  for (int i = 0; i < kCells; ++i) {
    const auto next = std::size_t(i) + 1;
    const double after = normals_[next].dot(place) - distances_[next];
    if (before >= 0 && after < 0) {
      consider({parameter(place, i, before, after), false});
    }
    before = after;
  }
  if (before >= 0) {
    consider({1, true});
  }
  return nearest;
}

std::optional<Foot> SweptPatch::foot(const Vec3& place) const {
  Vec3 on = place;
  std::optional<Foot> foot = nearest_in_section(place, on);
  for (int i = 0; foot && i < kMostMoves; ++i) {
    // What is left of the way from the foot, along the surface.
    const Vec3 way = place - on;
    const Vec3 along = way - way.dot(foot->normal) * foot->normal;
    if (along.norm() <= kOff * box_.diagonal().norm()) {
      break;
    }
    foot = nearest_in_section(place - way.dot(foot->normal) * foot->normal, on);
  }
  if (foot) {
    foot->distance = (place - on).norm();
  }
  return foot;
}

}  // namespace dupin::shading
