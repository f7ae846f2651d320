#include "tessellation/kneecap_joint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "dupin/blends/cyclide_tube.h"

namespace dupin::tessellation {
namespace {

using std::numbers::pi;

// The circles are u.n1 = h1 and u.n2 = h2 on the unit sphere; they cross in
// u = a n1 + b n2 +- g (n1 x n2) with a + b c = h1, a c + b = h2, c = n1.n2, and
// |a n1 + b n2|^2 + g^2 |n1 x n2|^2 = 1.
bool cross(JointCircles& joint) {
  const Vec3 &n1 = joint.before.normal, &n2 = joint.after.normal;
  const Vec3 axis = n1.cross(n2);
  const double r = joint.sphere.r, c = n1.dot(n2), s2 = axis.squaredNorm();
  const double h1 = (joint.before.center - joint.sphere.m).dot(n1) / r;
  const double h2 = (joint.after.center - joint.sphere.m).dot(n2) / r;
  if (!(s2 > 0)) {
    return false;
  }
  const Vec3 middle = ((h1 - c * h2) / s2) * n1 + ((h2 - c * h1) / s2) * n2;
  const double rest = (1 - middle.norm()) * (1 + middle.norm());
  if (!(rest > 0)) {
    return false;
  }
  const Vec3 aside = std::sqrt(rest) * joint.hinge;
  joint.corners = {joint.sphere.m + r * (middle + aside), joint.sphere.m + r * (middle - aside)};
  return true;
}

double angle_about(const Ring& circle, const Vec3& from, const Vec3& to) {
  return std::atan2(circle.normal.dot(from.cross(to)), from.dot(to));
}

}  // namespace

JointCircles joint(const PeArc& before, const PeArc& after, double negligible, double grid) {
  JointCircles result;
  result.sphere = before.end();
  result.before = circle_at(before, 1);
  result.after = circle_at(after, 0);
  result.apart = circle_distance(result.before, result.after);
  if (result.apart <= negligible) {
    result.after = result.before;
    result.hinge = reference_axis(result.before);
    return result;
  }
  const Vec3 axis = result.before.normal.cross(result.after.normal);
  result.apart = 0;
  // A shorter product is mostly rounding, and the normals agree to more digits than it has.
  constexpr double kNoAxis = 0x1p-40;
  result.hinge = axis.norm() > kNoAxis ? axis.normalized() : reference_axis(result.before);
  if (cross(result) && (result.corners[0] - result.corners[1]).norm() > kSameCorners * grid) {
    result.kind = JointKind::lune;
    return result;
  }
  const SphericalJoint knee = spherical_joint(before, after);
  // Circles that touch, up to rounding, are on the side that their caps' sum of angles says.
  result.kind = knee.before + knee.after <= pi ? JointKind::band : JointKind::hidden;
  return result;
}

Vec3 outward(const JointCircles& joint, const Vec3& normal) {
  return normal.cross(joint.hinge).normalized();
}

Vec3 band_start(const JointCircles& joint, const Vec3& normal, std::size_t segments) {
  const Vec3 narrowest = -outward(joint, normal);
  const double half = pi / double(segments);
  return std::cos(half) * narrowest + std::sin(half) * normal.cross(narrowest);
}

JointPolygon joint_polygon(const JointCircles& joint, const Ring& circle, std::uint32_t segments,
                           double grid) {
  JointPolygon result;
  double arc = 2 * pi;
  std::uint32_t exposed = segments;
  result.first = band_start(joint, circle.normal, segments);
  if (joint.kind == JointKind::lune) {
    result.first = (joint.corners[0] - circle.center).normalized();
    arc = 2 * std::abs(angle_about(circle, result.first, outward(joint, circle.normal)));
    const double wanted = std::ceil((segments - 1) * arc / (2 * pi));
    exposed = std::clamp(std::uint32_t(wanted), 1U, segments - 1);
  }
  const Vec3 second = circle.normal.cross(result.first);
  for (std::uint32_t i = 0; i < segments; ++i) {
    const double angle = i < exposed ? arc * i / exposed
                                     : arc + (2 * pi - arc) * (i - exposed) / (segments - exposed);
    const Vec3 direction = std::cos(angle) * result.first + std::sin(angle) * second;
    result.angles.push_back(angle);
    result.points.push_back(snapped(circle.center + circle.radius * direction, grid));
  }
  if (joint.kind == JointKind::lune) {
    result.points[0] = snapped(joint.corners[0], grid);
    result.points[exposed] = snapped(joint.corners[1], grid);
    result.exposed = exposed;
  } else {
    result.exposed = joint.kind == JointKind::band ? segments : 0;
  }
  return result;
}

}  // namespace dupin::tessellation
