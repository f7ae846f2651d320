#include <cmath>

#include "dupin/blends/rational_ringed_surface.h"
#include "dupin/blends/ringed_blend.h"
#include "dupin/kernel/error.h"

namespace dupin {

RationalRingedTube oblique_tube(const Vec3& from, const Vec3& to, const Vec3& normal,
                                double start_radius, double end_radius) {
  if (!from.allFinite() || !normal.allFinite() || !(normal.norm() > 0)) {
    throw Error(Errc::invalid_argument,
                "an oblique part needs finite points and a normal that is not zero");
  }
  const Vec3 unit = normal.normalized();
  const double slope = (end_radius - start_radius) / (to - from).dot(unit);
  return oblique_tube(flipped(Ring{from, unit, start_radius, std::isfinite(slope) ? slope : 0}), to,
                      end_radius);
}

RationalRingedTube oblique_tube(const Ring& start, const Vec3& to, double end_radius) {
  validate(start);
  if (!to.allFinite()) {
    throw Error(Errc::invalid_argument, "an oblique part needs finite points");
  }
  const Ring first = flipped(start);
  const Vec3 travel = to - first.center;
  if (!(travel.dot(first.normal) > 0)) {
    throw Error(Errc::invalid_argument,
                "the normal must be less than 90 degrees off the direction of travel");
  }
  const double slope = (end_radius - first.radius) / travel.dot(first.normal);
  const Ring end{to, first.normal, end_radius, slope};
  validate(end);
  const MovingRing motion{
      first.center, first.normal, first.radius, travel, end_radius - first.radius, Vec3::Zero()};
  MovingRing last = motion;
  last.center = to;
  last.radius = end_radius;
  return {start, end, ringed_blend(motion, last)};
}

MovingRing reversed(const MovingRing& ring) {
  MovingRing result = ring;
  result.normal = Vec3::Zero() - ring.normal;
  result.center_rate = Vec3::Zero() - ring.center_rate;
  result.radius_rate = 0 - ring.radius_rate;
  return result;
}

MovingRing at_speed(const MovingRing& ring, double factor) {
  MovingRing result = ring;
  result.center_rate *= factor;
  result.radius_rate *= factor;
  result.normal_rate *= factor;
  return result;
}

MovingRing leaving(const RationalRingedTube& tube, End end) {
  const Ring& stored = end == End::start ? tube.start : tube.end;
  const MovingRing travelling = ring_at(tube.surface, end == End::start ? 0 : 1);
  MovingRing result = end == End::start ? reversed(travelling) : travelling;
  result.center = stored.center;
  result.normal = stored.normal;
  result.radius = stored.radius;
  // A ring that comes out of a plate stands still; its radius alone moves.
  const double speed = std::hypot(result.center_rate.norm(), result.radius_rate);
  return at_speed(result, 1 / speed);
}

}  // namespace dupin
