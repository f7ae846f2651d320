#include <cmath>
#include <numbers>
#include <string>

#include "assembly/parts/line_and_arc.h"
#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"
#include "assembly/parts/start_ring.h"
#include "dupin/kernel/decimal.h"

namespace dupin::assembly {
namespace {

// With e = to - start.center = p travel + q inward, the chord turns by half the angle:
// tan(angle / 2) = q / p, bend radius = (p^2 + q^2) / (2 q).
PartSurface elbow_to(const PartContext& context, const Ring& start, const Vec3& to) {
  check_finite(context, to, "to");
  const Vec3 travel = opposite(start.normal), chord = to - start.center;
  const double p = chord.dot(travel);
  const Vec3 across = chord - p * travel;
  const double q = across.norm();
  if (!(q > kNoDirection * chord.norm())) {
    fail(context, "to", "the point lies on the axis; a pipe leads there");
  }
  const Vec3 inward = across / q;
  const double squared = p * p + q * q;
  const double cosine = (p * p - q * q) / squared, sine = 2 * p * q / squared;
  const Ring end{to, plain(cosine * travel + sine * inward), start.radius};
  return arc(start, end, inward, squared / (2 * q), 2 * std::atan2(q, p));
}

}  // namespace

template <>
struct PartRules<"elbow"> {
  static References references(const auto& elbow) { return from_port(elbow.from); }

  static PartSurface geometry(const PartContext& context, const ElbowTurning& elbow) {
    const Ring start = origin(context, elbow.from, kSection);
    check_positive(context, elbow.bend_radius, "bend_radius");
    if (!(elbow.angle > 0 && elbow.angle < 2 * std::numbers::pi)) {
      fail(context, "angle",
           "an elbow's angle must lie between 0 and 360 degrees, not at " +
               decimal(elbow.angle / std::numbers::pi * 180, kMessageDigits));
    }
    check_finite(context, elbow.toward, "toward");
    const Vec3 travel = opposite(start.normal);
    const Vec3 across = elbow.toward - elbow.toward.dot(travel) * travel;
    if (!(across.norm() > kNoDirection * elbow.toward.norm())) {
      fail(context, "toward", "the direction must have a part across the direction of travel");
    }
    const Vec3 inward = across.normalized();
    const auto [cosine, sine] = cosine_and_sine(elbow.angle);
    const Vec3 end = start.center + elbow.bend_radius * (1 - cosine) * inward +
                     elbow.bend_radius * sine * travel;
    return arc(start, {end, plain(cosine * travel + sine * inward), start.radius}, inward,
               elbow.bend_radius, elbow.angle);
  }

  static PartSurface geometry(const PartContext& context, const ElbowTo& elbow) {
    return elbow_to(context, origin(context, elbow.from, kSection), elbow.to);
  }

  // Both legs subtend half the angle a from the bend's centre: leg = bend radius tan(a / 2), and
  // tan(a / 2) = sin a / (1 + cos a). The direction at the end comes from the corner alone, so that
  // roundings of a long line's coordinates do not add up.
  static PartSurface geometry(const PartContext& context, const ElbowCorner& elbow) {
    check_finite(context, elbow.corner, "corner");
    check_finite(context, elbow.to, "to");
    const Ring start = origin(context, elbow.from, kSection);
    const Vec3 travel = opposite(start.normal), to_corner = elbow.corner - start.center;
    const double first = to_corner.dot(travel), second = (elbow.to - elbow.corner).norm();
    const double aside = (to_corner - first * travel).norm();
    check_within_tolerance(context, aside, "corner",
                           "the corner is " + decimal(aside, kMessageDigits) + " off the axis");
    check_within_tolerance(context, std::abs(first - second), "corner",
                           "the legs from the corner are " + decimal(first, kMessageDigits) +
                               " and " + decimal(second, kMessageDigits) + " long");
    if (!(second >= kSmallest)) {
      fail(context, "to", "the point must be 1e-12 or more away from the one at 'corner'");
    }
    const Vec3 leaving = (elbow.to - elbow.corner).normalized();
    const double cosine = travel.dot(leaving);
    const Vec3 across = leaving - cosine * travel;
    const double sine = across.norm();
    if (!(sine > kNoDirection)) {
      fail(context, "to", "the corner is none: both legs lie on one line");
    }
    const Ring end{plain(start.center + second * (travel + leaving)), plain(leaving), start.radius};
    return arc(start, end, across / sine, second * (1 + cosine) / sine, std::atan2(sine, cosine));
  }
};
template const PartKind& part_kind<"elbow">();

}  // namespace dupin::assembly
