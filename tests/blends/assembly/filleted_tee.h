#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/blends/canal_fillet.h"
#include "dupin/blends/resolve.h"
#include "support/named_parts.h"

namespace dupin::test {

/// A branch on a run, or through it, by what tells such tees apart: shares of the run's radius, and
/// of the branch's that of the ball.
struct Tee {
  double ratio, offset, angle, ball;

  static constexpr double kRun = 4;

  [[nodiscard]] double radius_of_ball() const { return ball * ratio * kRun; }

  [[nodiscard]] Assembly document(bool with_fillet, double tolerance = 0.02) const {
    const double branch = ratio * kRun, aside = offset * kRun, rho = radius_of_ball();
    const Vec3 direction(std::cos(angle), std::sin(angle), 0);
    const double length =
        (kRun + branch + 3 * rho + branch * std::cos(angle)) / std::sin(angle) + 6;
    const double half = 2 * length;
    // Beside the axis it may leave the run: it has to pass through then.
    const bool passes = offset + ratio > 1;
    const Vec3 at(0, 0, aside);
    std::vector<Part> parts{pipe("run", {-half, 0, 0}, {half, 0, 0}, kRun),
                            pipe("branch", passes ? Vec3(at - length * direction) : at,
                                 at + length * direction, branch)};
    if (with_fillet) {
      parts.push_back(fillet("throat", "run", "branch", rho));
    }
    return {"d.json", Unit::millimetre, tolerance, {}, std::move(parts)};
  }
};

/// Area, and the integral of x.n over it, which is three times the volume of what it bounds.
struct Measures {
  double area = 0, flux = 0;

  friend Measures operator+(const Measures& a, const Measures& b) {
    return {a.area + b.area, a.flux + b.flux};
  }
  friend Measures operator-(const Measures& a, const Measures& b) {
    return {a.area - b.area, a.flux - b.flux};
  }
  // Of a region, whatever way its curve was passed.
  [[nodiscard]] Measures turned() const { return area < 0 ? Measures{-area, -flux} : *this; }
};

/// Of pipes with fillets as they are meant to be, by integrals along the balls' ways alone: strips
/// of the fillets, cylinders less what their feet bound, and discs.
class FilletIntegrals {
 public:
  explicit FilletIntegrals(const ResolvedAssembly& resolved) : resolved_(resolved) {}

  [[nodiscard]] Measures whole() const {
    Measures sum;
    for (const ResolvedFillet& fillet : resolved_.fillets) {
      for (const CanalFillet& loop : fillet.shape.loops) {
        sum = sum + strip(loop);
      }
    }
    for (std::uint32_t part = 0; part < resolved_.parts.size(); ++part) {
      sum = sum + face(part);
    }
    return sum;
  }

 private:
  static constexpr int kAlong = 4000, kAcross = 40;
  static constexpr double kTurn = 2 * std::numbers::pi;

  // The element of area of the envelope of equal balls; out of the solid is into them.
  static Measures strip(const CanalFillet& loop) {
    Measures sum;
    for (int i = 0; i < kAlong; ++i) {
      const double step = kTurn / kAlong;
      const MovingBall at = ball(loop, (i + 0.5) * step);
      const ContactArc arc = contact_arc(loop.quadrics, at);
      for (int j = 0; j < kAcross; ++j) {
        const Vec3 x = point(arc, (j + 0.5) * arc.angle / kAcross);
        const Vec3 out = (at.center - x) / at.radius;
        const double bend = 1 + at.radius * at.acceleration.dot(out) / at.velocity.squaredNorm();
        const double area =
            bend * at.velocity.norm() * at.radius * step * arc.angle / double(kAcross);
        sum = sum + Measures{area, x.dot(out) * area};
      }
    }
    return sum;
  }

  struct Side {
    Measures below;   // the curve, from the start of its pipe on
    double turn = 0;  // about the axis
  };

  static Side side(const CanalFillet& loop, std::size_t which, const Ring& start) {
    const Vec3 axis = -start.normal;
    const auto foot = [&](int i) {
      return Vec3(contact_arc(loop.quadrics, ball(loop, kTurn * i / kAlong)).feet.at(which) -
                  start.center);
    };
    const auto arm = [&](const Vec3& x) { return Vec3(x - x.dot(axis) * axis); };
    Side result;
    Vec3 a = foot(0);
    for (int i = 1; i <= kAlong; ++i) {
      const Vec3 b = foot(i);
      const double turn = std::atan2(arm(a).cross(arm(b)).dot(axis), arm(a).dot(arm(b)));
      const Vec3 normal = (arm(a) + arm(b)).normalized();
      const double area = start.radius * turn * (a + b).dot(axis) / 2;
      result.below =
          result.below + Measures{area, area * (start.radius + normal.dot(start.center))};
      result.turn += turn;
      a = b;
    }
    return result;
  }

  [[nodiscard]] Measures face(std::uint32_t part) const {
    const auto& chain = std::get<Chain>(resolved_.parts[part].shape);
    const std::array<Ring, 2> rings{end_ring(chain, End::start), end_ring(chain, End::end)};
    const double r = rings[0].radius, length = (rings[1].center - rings[0].center).norm();
    const Measures all{kTurn * r * length, kTurn * r * length * r};
    std::array<bool, 2> buried{};
    std::vector<Measures> about;
    Measures sum;
    for (const ResolvedFillet& fillet : resolved_.fillets) {
      for (std::size_t i = 0; i < 2; ++i) {
        if (fillet.between.at(i) != part) {
          continue;
        }
        for (const CanalFillet& loop : fillet.shape.loops) {
          const Side of_loop = side(loop, i, rings[0]);
          if (std::abs(of_loop.turn) < kTurn / 2) {
            sum = sum - of_loop.below.turned();
          } else {
            about.push_back(of_loop.turn > 0 ? of_loop.below : Measures{} - of_loop.below);
          }
        }
        for (std::size_t end = 0; end < 2; ++end) {
          buried.at(end) = buried.at(end) || fillet.shape.buried.at(i).at(end);
        }
      }
    }
    if (about.size() == 2) {
      sum = sum + all - (about[1] - about[0]).turned();
    } else if (buried[0]) {
      sum = sum + all - about.front();
    } else {
      sum = sum + (buried[1] ? about.front() : all);
    }
    for (std::size_t end = 0; end < 2; ++end) {
      const Ring& ring = rings.at(end);
      const double disc = buried.at(end) ? 0 : std::numbers::pi * r * r;
      sum = sum + Measures{disc, disc * ring.center.dot(ring.normal)};
    }
    return sum;
  }

  const ResolvedAssembly& resolved_;
};

}  // namespace dupin::test
