#include "dupin/blends/ringed_blend.h"

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/blends/rational_ringed_surface.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/ring.h"
#include "numbers/quaternion.h"

namespace dupin {
namespace {

using numbers::product;
using Quaternion = numbers::Quaternion<double>;

// Of the rotation matrix [normal | seam | normal x seam], real part not negative.
Quaternion start_rotation(const Vec3& normal) {
  int smallest = 0;
  normal.cwiseAbs().minCoeff(&smallest);
  const Vec3 axis = Vec3::Unit(smallest);
  const Vec3 seam = (axis - axis.dot(normal) * normal).normalized();
  Eigen::Matrix3d matrix;
  matrix << normal, seam, normal.cross(seam);
  Eigen::Quaterniond q(matrix);
  if (q.w() < 0) {
    q.coeffs() *= -1;
  }
  return {q.w(), q.x(), q.y(), q.z()};
}

// The least rotation from one normal to another, after `start`.
Quaternion end_rotation(const Quaternion& start, const Vec3& from, const Vec3& to) {
  const double w = 1 + from.dot(to);
  const Vec3 axis = from.cross(to);
  const double length = std::hypot(w, axis.norm());
  // 1 + cos a and sin a both vanish at a half turn; below 2^-40 of it the axis is rounding noise.
  if (!(length > std::ldexp(1, -40))) {
    throw Error(Errc::infeasible_blend,
                "the rings' normals are opposite; put a ring across between them");
  }
  return numbers::product({w / length, axis.x() / length, axis.y() / length, axis.z() / length},
                          start);
}

// dA/dt that turns n = A i A* at the rate wanted and leaves |A| as it is.
Quaternion rotation_rate(const Quaternion& a, const MovingRing& ring) {
  const Vec3 omega = ring.normal.cross(ring.normal_rate);
  return numbers::product({0, omega.x() / 2, omega.y() / 2, omega.z() / 2}, a);
}

Quaternion moved(const Quaternion& a, double factor, const Quaternion& by) {
  return {a[0] + factor * by[0], a[1] + factor * by[1], a[2] + factor * by[2],
          a[3] + factor * by[3]};
}

RationalRingedSurface between(const MovingRing& from, const MovingRing& to,
                              const std::vector<Quaternion>& rotation) {
  return {
      {from.center, from.center + from.center_rate / 3, to.center - to.center_rate / 3, to.center},
      {from.radius, from.radius + from.radius_rate / 3, to.radius - to.radius_rate / 3, to.radius},
      rotation};
}

RationalRingedSurface proven(const RationalRingedSurface& surface) {
  if (!proves_regular(surface)) {
    throw Error(Errc::irregular_surface,
                "the blend's discs overlap, or its radius vanishes; change the speeds at its ends");
  }
  return surface;
}

void validate(const MovingRing& ring) {
  validate(Ring{ring.center, ring.normal, ring.radius});
  if (!ring.center_rate.allFinite() || !std::isfinite(ring.radius_rate) ||
      !ring.normal_rate.allFinite()) {
    throw Error(Errc::invalid_argument, "a moving ring's rates must be finite numbers");
  }
}

}  // namespace

RationalRingedSurface ringed_blend(const MovingRing& from, const MovingRing& to) {
  validate(from);
  validate(to);
  const Quaternion a0 = start_rotation(from.normal);
  const Quaternion a1 = end_rotation(a0, from.normal, to.normal);
  return proven(between(from, to,
                        {a0, moved(a0, 1. / 3, rotation_rate(a0, from)),
                         moved(a1, -1. / 3, rotation_rate(a1, to)), a1}));
}

RationalRingedSurface canal_ringed_blend(const CanalEnd& from, const CanalEnd& to) {
  for (const TravelRing& ring : {from.ring, to.ring}) {
    validate(Ring{ring.center, ring.normal, ring.radius});
  }
  const Quaternion a0 = start_rotation(from.ring.normal);
  const Quaternion a1 = end_rotation(a0, from.ring.normal, to.ring.normal);
  const RationalRingedSurface turning{{}, {}, {a0, a1}};
  const auto moving = [&](const CanalEnd& end, double t) {
    return along_canal(end.ring, end.slope, end.speed, ring_at(turning, t).normal_rate);
  };
  return proven(between(moving(from, 0), moving(to, 1), {a0, a1}));
}

}  // namespace dupin
