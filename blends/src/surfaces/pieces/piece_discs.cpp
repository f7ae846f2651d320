#include "surfaces/pieces/piece_discs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace dupin::surfaces {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vec3 center(const numbers::IntervalVec& v) {
  return {(v[0].lower + v[0].upper) / 2, (v[1].lower + v[1].upper) / 2,
          (v[2].lower + v[2].upper) / 2};
}

DiscHull hull_of(const SweptDiscTube& tube, const ParameterInterval& t) {
  SweptDiscTube::Part part = tube.curve(t);
  DiscHull result{
      std::move(part.centers), std::move(part.tangents), Vec3::Zero(), 1, tube.radius(t), 0};
  for (const numbers::IntervalVec& tangent : result.tangents) {
    result.axis += center(tangent).normalized();
  }
  result.axis.normalize();
  const numbers::IntervalVec axis = numbers::interval_vec(result.axis);
  for (const numbers::IntervalVec& tangent : result.tangents) {
    const numbers::Interval scale = numbers::norm(tangent) * numbers::norm(axis);
    const double cosine = scale.lower > 0 ? (numbers::dot(tangent, axis) / scale).lower : 0;
    result.cosine = std::min(result.cosine, std::max(cosine, 0.0));
  }
  return result;
}

// Centres by the mean value theorem from the middle, normals by how far they turn from there. Where
// nothing is known, the discs may be anywhere.
DiscHull hull_of(const DiscMotion& moving, const ParameterInterval& t) {
  const double middle = (t.from + t.to) / 2;
  const auto here = moving(middle, false), all = moving({t.from, t.to}, false);
  if (!here || !all) {
    return {{{}}, {{}}, Vec3::UnitX(), 0, {0, kInfinity}, 0};
  }
  const numbers::Interval half = std::max((numbers::Interval(t.to) - middle).upper,
                                          (numbers::Interval(middle) - t.from).upper);
  const numbers::IntervalVec step = half * all->velocity;
  DiscHull result{{here->center - step, here->center + step},
                  {here->normal},
                  center(here->normal).normalized(),
                  0,
                  all->radius,
                  (half * numbers::norm(all->turning)).upper};
  result.cosine =
      (numbers::dot(here->normal, numbers::interval_vec(result.axis)) / numbers::norm(here->normal))
          .lower;
  return result;
}

}  // namespace

Vec3 DiscHull::middle() const { return (center(centers.front()) + center(centers.back())) / 2; }

double DiscHull::extent() const {
  double length = radius.upper == kInfinity ? kInfinity : 0;
  for (std::size_t i = 0; i + 1 < centers.size(); ++i) {
    length += (center(centers[i + 1]) - center(centers[i])).norm();
  }
  return length;
}

// A disc of normal T reaches as far as R |T x w|; the sine of the angle between T and w is largest
// at the normal nearest to a right angle, which the cone about the axis bounds.
double support(const DiscHull& hull, const Vec3& w) {
  const numbers::IntervalVec direction = numbers::interval_vec(w),
                             axis = numbers::interval_vec(hull.axis);
  numbers::Interval sine = 1;
  if (hull.cosine > 0) {
    const numbers::Interval scale = numbers::norm(axis) * numbers::norm(direction),
                            cosine = hull.cosine;
    const numbers::Interval across = numbers::norm(numbers::cross(axis, direction)) / scale;
    numbers::Interval along = numbers::dot(axis, direction) / scale;
    along = {0, along.magnitude()};
    if (across.upper <= hull.cosine) {
      sine = across * cosine + along * numbers::sqrt(numbers::Interval(1) - square(cosine)) +
             hull.spread;
    }
  }
  double furthest = -kInfinity;
  for (const numbers::IntervalVec& point : hull.centers) {
    furthest = std::max(furthest, numbers::dot(point, direction).upper);
  }
  const numbers::Interval reach =
      numbers::Interval(hull.radius.upper) * numbers::norm(direction) * std::min(sine.upper, 1.0);
  return (numbers::Interval(furthest) + reach).upper;
}

Vec3 support_point(const DiscHull& hull, const Vec3& direction) {
  Vec3 furthest = center(hull.centers.front());
  for (const numbers::IntervalVec& point : hull.centers) {
    if (center(point).dot(direction) > furthest.dot(direction)) {
      furthest = center(point);
    }
  }
  Vec3 across = direction;
  if (hull.cosine > 0) {
    across -= direction.dot(hull.axis) * hull.axis;
  }
  // Along the axis, what is left is rounding and every point of the disc is as far as its centre.
  const double length = across.norm();
  return length > 0x1p-40 * direction.norm() ? Vec3(furthest + hull.radius.upper / length * across)
                                             : furthest;
}

std::pair<ParameterInterval, ParameterInterval> halves(const ParameterInterval& t) {
  const double middle = (t.from + t.to) / 2;
  return {{t.from, middle}, {middle, t.to}};
}

PieceDiscs discs_of(const SweptDiscTube& tube, bool full) {
  return {
      [tube](const ParameterInterval& t) { return hull_of(tube, t); },
      [tube](const ParameterInterval& t) { return tube.pace(t); },
      [tube](const ParameterInterval& t, double margin) { return tube.turns_little(t, margin); },
      [tube](const ParameterInterval& t) { return tube.stays_on_one_side(t); }, full};
}

PieceDiscs discs_of(const DiscMotion& motion) {
  return {[motion](const ParameterInterval& t) { return hull_of(motion, t); },
          [motion](const ParameterInterval& t) {
            const auto disc = motion({t.from, t.to}, true);
            return disc ? std::optional(pace(*disc, (numbers::Interval(t.to) - t.from).upper))
                        : std::nullopt;
          },
          [](const ParameterInterval&, double) { return false; },
          [](const ParameterInterval&) { return false; }, true};
}

}  // namespace dupin::surfaces
