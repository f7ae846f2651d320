#include "dupin/blends/moving_ring.h"

#include <cmath>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/ring.h"

namespace dupin {
namespace {

void validate(const TravelRing& ring) { validate(Ring{ring.center, ring.normal, ring.radius}); }

void require_speed(double speed) {
  if (!(std::isfinite(speed) && speed > 0)) {
    throw Error(Errc::invalid_argument,
                "a ring's speed must be a positive number, not " + decimal(speed, kMessageDigits));
  }
}

}  // namespace

MovingRing along_canal(const TravelRing& ring, double slope, double speed,
                       const Vec3& normal_rate) {
  validate(ring);
  require_speed(speed);
  return {ring.center,   ring.normal,
          ring.radius,   speed * ring.normal - slope * ring.radius * normal_rate,
          slope * speed, normal_rate};
}

MovingRing along_sphere(const TravelRing& ring, const Vec3& center, double speed) {
  const Vec3 ahead = center - ring.center;
  const double height = ahead.dot(ring.normal);
  if (!((ahead - height * ring.normal).norm() <= 1e-9 * ring.radius)) {
    throw Error(Errc::invalid_argument,
                "the ring is no circle of that sphere: its axis misses the sphere's centre");
  }
  return along_canal(ring, height / ring.radius, speed);
}

MovingRing along_oblique_cone(const TravelRing& ring, const Vec3& apex, double speed) {
  validate(ring);
  require_speed(speed);
  const bool widening = (ring.center - apex).dot(ring.normal) > 0;
  const Vec3 ruling = widening ? Vec3(ring.center - apex) : Vec3(apex - ring.center);
  return {ring.center,
          ring.normal,
          ring.radius,
          speed * ruling,
          (widening ? speed : -speed) * ring.radius,
          Vec3::Zero()};
}

MovingRing along_oblique_cylinder(const TravelRing& ring, const Vec3& direction, double speed) {
  validate(ring);
  require_speed(speed);
  return {ring.center, ring.normal, ring.radius, speed * direction, 0, Vec3::Zero()};
}

MovingRing along_plate(const TravelRing& ring, double speed) {
  validate(ring);
  require_speed(std::abs(speed));
  return {ring.center, ring.normal, ring.radius, Vec3::Zero(), speed, Vec3::Zero()};
}

}  // namespace dupin
