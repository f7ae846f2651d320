#include "shading/section_family.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <variant>

#include <Eigen/Geometry>

#include "dupin/blends/frame.h"

namespace dupin::shading {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;

// From the centre of the ball to its contact circle, by its radius.
Vec3 of_ball(const Section& circle, const Vec3& ball, const Vec3& direction) {
  return (circle.center + circle.along * direction - ball).normalized();
}

struct FamilyOf {
  SectionFamily operator()(const RingedSurface& tube) const {
    return {[spine = tube.spine, law = tube.radius](double t) {
              const SpinePoint y = evaluate(spine, t);
              const double radius = evaluate(law, t).value;
              return Section{y.position, y.first.normalized(), Vec3::Zero(), radius, radius};
            },
            [spine = tube.spine, law = tube.radius](double t, const Vec3& direction) {
              // Across both x_u and x_t, which is (|y'| - R e.T') T + R' e but for a part along
              // x_u.
              const SpinePoint y = evaluate(spine, t);
              const RadiusValue radius = evaluate(law, t);
              const double speed = y.first.norm();
              const double advance = speed - radius.value * direction.dot(y.second) / speed;
              return Vec3((advance * direction - radius.first * y.first / speed).normalized());
            }};
  }

  SectionFamily operator()(const EllipticTube& own) const {
    const auto tube = std::make_shared<EllipticTube>(own);
    const auto field = std::make_shared<FrameField>(frames(own));
    const auto section = [tube, field](double t) {
      const SpinePoint y = evaluate(tube->spine, t);
      const Vec3 axis = (evaluate(*tube, *field, t, 0).position - y.position).normalized();
      return Section{y.position, y.first.normalized(), axis, evaluate(tube->first, t).value,
                     evaluate(tube->second, t).value};
    };
    return {section, [tube, field, section](double t, const Vec3& direction) {
              const Section at = section(t);
              const double u = std::atan2(direction.dot(at.normal.cross(at.axis)) / at.across,
                                          direction.dot(at.axis) / at.along);
              return evaluate(*tube, *field, t, u).normal;
            }};
  }

  SectionFamily operator()(const CyclidePiece& piece) const {
    const auto section = [arc = arc_of(piece)](double t) {
      const Ring circle = circle_at(arc, t);
      return Section{circle.center, circle.normal, Vec3::Zero(), circle.radius, circle.radius};
    };
    return {section, [section, arc = arc_of(piece)](double t, const Vec3& direction) {
              return of_ball(section(t), sphere_at(arc, t).m, direction);
            }};
  }

  SectionFamily operator()(const RationalRingedTube& tube) const {
    return {[surface = tube.surface](double t) {
              const MovingRing ring = ring_at(surface, t);
              return Section{ring.center, ring.normal, Vec3::Zero(), ring.radius, ring.radius};
            },
            [surface = tube.surface](double t, const Vec3& direction) {
              const Vec3 center = ring_at(surface, t).center;
              const double u =
                  std::atan2(direction.dot(evaluate(surface, t, kQuarter).position - center),
                             direction.dot(evaluate(surface, t, 0).position - center));
              return evaluate(surface, t, u).normal;
            }};
  }
};

// Where the ball touches the envelope of its motion.
Section contact_circle(const MovingBall& ball) {
  const double speed = ball.velocity.norm();
  const double share = ball.radius_rate / speed;
  const double radius = ball.radius * std::sqrt(std::max(0.0, 1 - share * share));
  const Vec3 normal = ball.velocity / speed;
  return {ball.center - ball.radius * share * normal, normal, Vec3::Zero(), radius, radius};
}

// Of a parameter.
constexpr double kBesideCorner = 0x1p-40;

SectionFamily between(const CanalFillet& fillet, double from, double to) {
  const auto moving = [fillet, from, to](double t) {
    return ball(fillet, std::remainder(from + t * (to - from), 2 * std::numbers::pi));
  };
  return {[moving](double t) { return contact_circle(moving(t)); },
          [moving](double t, const Vec3& direction) {
            const MovingBall at = moving(t);
            return of_ball(contact_circle(at), at.center, direction);
          }};
}

}  // namespace

double Section::radius(const Vec3& direction) const {
  if (along == across) {
    return along;
  }
  const double c = direction.dot(axis), s = direction.dot(normal.cross(axis));
  return 1 / std::hypot(c / along, s / across);
}

SectionFamily section_family(const Piece& piece) { return std::visit(FamilyOf{}, piece); }

std::vector<SectionFamily> section_families(const CanalFillet& fillet) {
  constexpr double kTurn = 2 * std::numbers::pi;
  std::vector<double> ends = corners(fillet);
  const bool has_corners = !ends.empty();
  std::ranges::sort(ends);
  ends.push_back(has_corners ? ends.front() + kTurn : std::numbers::pi);
  if (!has_corners) {
    ends.insert(ends.begin(), -std::numbers::pi);
  }
  std::vector<SectionFamily> result;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    // At a corner itself, rounding would choose the side.
    const double rest = has_corners ? kBesideCorner : 0;
    result.push_back(between(fillet, ends[i] + rest, ends[i + 1] - rest));
  }
  return result;
}

}  // namespace dupin::shading
