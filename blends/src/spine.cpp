#include "dupin/blends/spine.h"

#include <cmath>

#include <Eigen/Geometry>

namespace dupin {
namespace {

SpinePoint at(const LineSpine& line, double t) {
  const Vec3 along = line.to - line.from;
  return {t == 1 ? line.to : Vec3(line.from + t * along), along, Vec3::Zero(), Vec3::Zero()};
}

SpinePoint at(const ArcSpine& arc, double t) {
  const Vec3 u = arc.start - arc.center;
  const Vec3 v = arc.axis.cross(u);
  const double w = arc.angle, c = std::cos(w * t), s = std::sin(w * t);
  const Vec3 out = c * u + s * v, along = c * v - s * u;
  return {arc.center + out, w * along, -w * w * out, -w * w * w * along};
}

SpinePoint at(const HermiteSpine& h, double t) {
  const Vec3 delta = h.to - h.from;
  const Vec3 a = h.start_velocity;
  const Vec3 b = 6 * delta - 4 * h.start_velocity - 2 * h.end_velocity;
  const Vec3 d = 3 * h.start_velocity + 3 * h.end_velocity - 6 * delta;
  const Vec3 position = t == 1 ? h.to : Vec3(h.from + t * (a + t * (b / 2 + t * d / 3)));
  return {position, t == 1 ? h.end_velocity : Vec3(a + t * (b + t * d)), b + 2 * t * d, 2 * d};
}

}  // namespace

SpinePoint evaluate(const Spine& spine, double t) {
  return std::visit([t](const auto& s) { return at(s, t); }, spine);
}

double curvature(const SpinePoint& p) {
  const double speed = p.first.norm();
  return p.first.cross(p.second).norm() / (speed * speed * speed);
}

}  // namespace dupin
