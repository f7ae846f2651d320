#include "dupin/blends/canal_fillet.h"
#include <cmath>
#include <algorithm>
#include <Eigen/Geometry>
#include "dupin/kernel/error.h"
namespace dupin {
ContactArc contact_arc(const std::array<Ring, 2>& quadrics, const MovingBall& ball) {
  ContactArc arc;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec3 from = ball.center - quadrics[i].center;
    const Vec3 n = (from - from.dot(quadrics[i].normal) * quadrics[i].normal).normalized();
    arc.normals[i] = n;
    arc.feet[i] = ball.center - ball.radius * n;
  }
  arc.center = ball.center;
  arc.radius = ball.radius;
  arc.to_first = -arc.normals[0];
  const Vec3 t = ball.velocity.normalized();
  const double half = (arc.normals[0] - arc.normals[1]).norm() / 2;
  arc.angle = 2 * std::asin(std::min(1.0, half));
  arc.across = t.cross(arc.to_first);
  if (arc.across.dot(-arc.normals[1]) < 0) arc.across = -arc.across;
  arc.across.normalize();
  if (half < 1e-15) arc.angle = 0;
  return arc;
}
Vec3 point(const ContactArc& arc, double angle) {
  return arc.center + arc.radius * (std::cos(angle) * arc.to_first + std::sin(angle) * arc.across);
}
double least_regularity(const MovingBall& ball, const ContactArc& arc) {
  double least = 1e300;
  for (int i = 0; i <= 16; ++i) {
    const Vec3 e = (point(arc, arc.angle * i / 16) - arc.center) / arc.radius;
    least = std::min(least, 1 - ball.radius * ball.acceleration.dot(e) / ball.velocity.squaredNorm());
  }
  return least;
}
MovingBall ball(const CanalFillet& fillet, double be) {
  const RollingBall& b = fillet.motion;
  const double s = std::sin(be), c = std::cos(be);
  const double zr = b.d2 * s - b.h, dz = b.d2 * c, ddz = -b.d2 * s;
  double y, dy, ddy;
  if (b.d1 == b.d2 && b.h == 0) {
    const double sg = c < 0 ? -1 : 1;
    y = b.d1 * std::abs(c); dy = -sg * b.d1 * s; ddy = -sg * b.d1 * c;
  } else {
    y = std::sqrt((b.d1 - zr) * (b.d1 + zr)); dy = -zr * dz / y;
    ddy = (-dz * dz - zr * ddz - dy * dy) / y;
  }
  y *= b.side; dy *= b.side; ddy *= b.side;
  const double x = (b.d2 * c + y * b.cosine) / b.sine, dx = (-b.d2 * s + dy * b.cosine) / b.sine,
               ddx = (-b.d2 * c + ddy * b.cosine) / b.sine;
  return {b.origin + x * b.x + y * b.y + (b.z1 + zr) * b.z, dx * b.x + dy * b.y + dz * b.z,
          ddx * b.x + ddy * b.y + ddz * b.z, b.radius, 0, 0};
}
double acceleration_bound(const CanalFillet& fillet, double from, double to) {
  double most = 0;
  for (int i = 0; i <= 4; ++i) most = std::max(most, ball(fillet, from + (to - from) * i / 4).acceleration.norm());
  return 1.1 * most;
}
std::vector<CanalFillet> rolling_ball_fillets(const std::array<Ring, 2>& q, double radius) {
  const bool swap = q[1].radius > q[0].radius;
  const Ring &one = q[swap ? 1 : 0], &two = q[swap ? 0 : 1];
  RollingBall b;
  b.radius = radius;
  b.x = one.normal;
  b.cosine = one.normal.dot(two.normal);
  b.z = one.normal.cross(two.normal);
  b.sine = b.z.norm();
  if (b.sine < 1e-12) throw Error(Errc::infeasible_blend, "the axes are parallel");
  b.z /= b.sine;
  b.y = b.z.cross(b.x);
  const Vec3 d = two.center - one.center;
  const double along2 = -d.dot(b.y) / two.normal.dot(b.y);
  const Vec3 at2 = two.center + along2 * two.normal;
  b.origin = at2; b.h = (one.center - at2).dot(b.z); b.z1 = b.h;
  b.d1 = one.radius + radius; b.d2 = two.radius + radius;
  std::vector<CanalFillet> result;
  if (!(b.d2 + std::abs(b.h) <= b.d1)) throw Error(Errc::infeasible_blend, "no closed way round");
  for (const double side : {1., -1.}) { b.side = side; result.push_back({q, b}); }
  return result;
}
}  // namespace dupin
