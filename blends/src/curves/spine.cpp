#include "dupin/blends/spine.h"

#include <cmath>

#include <Eigen/Geometry>

#include "numbers/bezier.h"

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

SpinePoint at(const BezierSpine& bezier, double t) {
  SpinePoint y;
  if (bezier.weights.empty()) {
    const auto [p, p1, p2, p3] = numbers::bezier_jet(bezier.points, t);
    y = {p, p1, p2, p3};
  } else {
    std::vector<Vec3> weighted = bezier.points;
    for (std::size_t i = 0; i < weighted.size(); ++i) {
      weighted[i] *= bezier.weights[i];
    }
    // With y = p / w, the derivatives of y w = p.
    const auto [p, p1, p2, p3] = numbers::bezier_jet(weighted, t);
    const auto [w, w1, w2, w3] = numbers::bezier_jet(bezier.weights, t);
    y.position = p / w;
    y.first = (p1 - w1 * y.position) / w;
    y.second = (p2 - 2 * w1 * y.first - w2 * y.position) / w;
    y.third = (p3 - 3 * w1 * y.second - 3 * w2 * y.first - w3 * y.position) / w;
  }
  if (t == 0 || t == 1) {
    y.position = t == 0 ? bezier.points.front() : bezier.points.back();
  }
  return y;
}

// Bezier points of odd degree, the first half on the start's tangent, the second on the end's,
// equally spaced.
BezierSpine straight_ended(const HermiteSpine& ends, int degree) {
  BezierSpine result;
  for (int i = 0; 2 * i < degree; ++i) {
    result.points.push_back(ends.from + i * ends.start_velocity / degree);
  }
  for (int i = degree / 2; i >= 0; --i) {
    result.points.push_back(ends.to - i * ends.end_velocity / degree);
  }
  return result;
}

}  // namespace

BezierSpine quintic_spine(const HermiteSpine& ends) { return straight_ended(ends, 5); }

BezierSpine septic_spine(const HermiteSpine& ends) { return straight_ended(ends, 7); }

SpinePoint evaluate(const Spine& spine, double t) {
  return std::visit([t](const auto& s) { return at(s, t); }, spine);
}

double curvature(const SpinePoint& p) {
  const double speed = p.first.norm();
  return p.first.cross(p.second).norm() / (speed * speed * speed);
}

}  // namespace dupin
