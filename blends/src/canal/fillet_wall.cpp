#include "canal/fillet_wall.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace dupin::canal {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kAround = 96, kAcross = 4;
constexpr double kRounding = 1e-9;  // of the ball's radius

// The balls of one loop, to find the one whose centre is nearest.
class Balls {
 public:
  explicit Balls(const CanalFillet& loop) : loop_(loop) {
    for (int i = 0; i < kAround; ++i) {
      balls_.push_back(ball(loop, kTurn * i / kAround));
    }
  }

  // Whether the arc of the ball whose centre is nearest lies before the point, or less than the
  // wall behind it.
  [[nodiscard]] bool are_passed_by(const Vec3& p, double wall) const {
    const auto away = [&](const MovingBall& one) { return (one.center - p).norm(); };
    const auto nearest = std::ranges::min_element(balls_, {}, away);
    if (away(*nearest) <= nearest->radius - wall) {
      return false;
    }
    const double at = kTurn * double(nearest - balls_.begin()) / kAround;
    double low = at - kTurn / kAround, high = at + kTurn / kAround;
    for (int step = 0; step < 60; ++step) {
      const double third = (high - low) / 3;
      const bool is_below = away(ball(loop_, low + third)) < away(ball(loop_, high - third));
      (is_below ? high : low) = is_below ? high - third : low + third;
    }
    const ContactArc arc = contact_arc(loop_.quadrics, ball(loop_, (low + high) / 2));
    const Vec3 arm = p - arc.center;
    const double x = arm.dot(arc.to_first), y = arm.dot(arc.across), angle = std::atan2(y, x);
    return angle >= 0 && angle <= arc.angle &&
           std::hypot(x, y) > (1 + kRounding) * arc.radius - wall;
  }

 private:
  const CanalFillet& loop_;
  std::vector<MovingBall> balls_;
};

}  // namespace

bool breaks_through(std::span<const CanalFillet> inner, std::span<const CanalFillet> outer,
                    double wall) {
  const std::vector<Balls> inside(inner.begin(), inner.end());
  for (const CanalFillet& loop : outer) {
    for (int i = 0; i < kAround; ++i) {
      const ContactArc arc = contact_arc(loop.quadrics, ball(loop, kTurn * i / kAround));
      for (int k = 0; k <= kAcross; ++k) {
        const Vec3 p = point(arc, arc.angle * k / kAcross);
        if (std::ranges::any_of(inside,
                                [&](const Balls& balls) { return balls.are_passed_by(p, wall); })) {
          return true;
        }
      }
    }
  }
  return false;
}

}  // namespace dupin::canal
