#pragma once

#include "dupin/kernel/vec.h"

namespace dupin {

/// A circle that moves: what a ringed surface's end is given by. `normal` points in the direction
/// of travel at both ends of a blend; the rates are derivatives by the blend's parameter.
struct MovingRing {
  Vec3 center = Vec3::Zero(), normal = Vec3::UnitZ();
  double radius = 1;
  Vec3 center_rate = Vec3::UnitZ();
  double radius_rate = 0;
  Vec3 normal_rate = Vec3::Zero();  ///< orthogonal to the normal
};

/// A circle at rest, with its normal in the direction of travel.
struct TravelRing {
  Vec3 center = Vec3::Zero(), normal = Vec3::UnitZ();
  double radius = 1;
};

/// The rates that make a ringed surface tangent to what ends in the ring [BL15]; `speed` > 0 is
/// free and shapes the blend.
///
/// Of a cylinder (slope 0), cone, torus or any canal surface whose tangent cone there has slope
/// tan(half angle) in the direction of travel. The normal may turn at any rate.
[[nodiscard]] MovingRing along_canal(const TravelRing& ring, double slope, double speed,
                                     const Vec3& normal_rate = Vec3::Zero());
/// Of the sphere about `center`; a circle of it. Throws Error{invalid_argument} if the centre is
/// not on the ring's axis to 1e-9 of its radius.
[[nodiscard]] MovingRing along_sphere(const TravelRing& ring, const Vec3& center, double speed);
/// Of the cone with this apex, oblique or right: widening if the apex lies behind the ring.
[[nodiscard]] MovingRing along_oblique_cone(const TravelRing& ring, const Vec3& apex, double speed);
/// Of the cylinder with rulings along `direction`, oblique or right.
[[nodiscard]] MovingRing along_oblique_cylinder(const TravelRing& ring, const Vec3& direction,
                                                double speed);
/// Of the plane of the ring itself: growing into the hole, or closing to it if speed < 0.
[[nodiscard]] MovingRing along_plate(const TravelRing& ring, double speed);

}  // namespace dupin
