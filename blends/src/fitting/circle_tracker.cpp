#include "fitting/circle_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Dense>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::fitting {
namespace {

constexpr int kPoints = 24;
// Of the unknowns (centre, tilts of the normal along both axes by the radius, radius), which are
// all lengths: the distances of the points, and that the centre stays in its plane.
using Jacobian = Eigen::Matrix<double, kPoints + 1, 6>;
using Residual = Eigen::Matrix<double, kPoints + 1, 1>;
using Unknowns = Eigen::Matrix<double, 6, 1>;

struct Axes {
  Vec3 first, second;
};

Axes axes_of(const Vec3& normal) {
  const Vec3 first = normal.unitOrthogonal();
  return {first, normal.cross(first)};
}

struct System {
  Jacobian jacobian;
  Residual residual;
};

System system_of(const ImplicitSurface& surface, const TravelRing& ring, const Vec3& along,
                 const Vec3& in_plane) {
  System result;
  const Axes axes = axes_of(ring.normal);
  for (int k = 0; k < kPoints; ++k) {
    const double angle = 2 * std::numbers::pi * k / kPoints;
    const double c = std::cos(angle), s = std::sin(angle);
    const Vec3 out = c * axes.first + s * axes.second, point = ring.center + ring.radius * out;
    const Vec3 gradient = surface.gradient(point);
    const double size = gradient.norm();
    const Vec3 unit = gradient / size;
    const double off_plane = -unit.dot(ring.normal);
    result.residual[k] = std::isfinite(size) ? surface.value(point) / size : size;
    result.jacobian.row(k) << unit.transpose(), c * off_plane, s * off_plane, unit.dot(out);
  }
  // As heavy as all points, so that it holds whatever they want.
  result.residual[kPoints] = kPoints * along.dot(ring.center - in_plane);
  result.jacobian.row(kPoints) << kPoints * along.transpose(), 0, 0, 0;
  return result;
}

TravelRing moved(const TravelRing& ring, const Unknowns& step) {
  const Axes axes = axes_of(ring.normal);
  return {ring.center + step.head<3>(),
          (ring.normal + (step[3] * axes.first + step[4] * axes.second) / ring.radius).normalized(),
          ring.radius + step[5]};
}

struct Circle {
  TravelRing ring;
  double defect = 0;
};

// Levenberg and Marquardt. Tilts that matter to the second order only are found by halves, to the
// root of rounding.
Circle circle(const ImplicitSurface& surface, const TravelRing& guess, const Vec3& along) {
  constexpr int kMostSteps = 200;
  constexpr double kNoGain = 1e-10, kRounding = 1e-15;
  TravelRing ring = guess;
  System system = system_of(surface, ring, along, guess.center);
  double damping = 1e-3;
  for (int i = 0; i < kMostSteps && system.residual.allFinite(); ++i) {
    const double before = system.residual.squaredNorm();
    Eigen::Matrix<double, 6, 6> normal_matrix = system.jacobian.transpose() * system.jacobian;
    normal_matrix.diagonal().array() += damping;
    const Unknowns step =
        normal_matrix.ldlt().solve(-system.jacobian.transpose() * system.residual);
    const TravelRing next = moved(ring, step);
    const System there = system_of(surface, next, along, guess.center);
    const double after = there.residual.squaredNorm();
    const bool is_better = next.radius > 0 && there.residual.allFinite() && after < before;
    const bool is_settled =
        (is_better ? before - after <= kNoGain * before : damping > 1e6) ||
        before <= kRounding * kRounding * (ring.radius * ring.radius + ring.center.squaredNorm());
    if (is_better) {
      ring = next;
      system = there;
    }
    damping *= is_better ? 0.1 : 10;
    if (is_settled) {
      return {ring, system.residual.head<kPoints>().cwiseAbs().maxCoeff()};
    }
  }
  throw Error(Errc::infeasible_blend, "no circle of the surface was found near " +
                                          decimal(guess.center) + ", radius " +
                                          decimal(guess.radius, kMessageDigits));
}

}  // namespace

void require_functions(const ImplicitSurface& surface) {
  if (!surface.value || !surface.gradient) {
    throw Error(Errc::invalid_argument,
                "an implicit surface needs a function and its gradient, and one of them is empty");
  }
}

double first_order_distance(const ImplicitSurface& surface, const Vec3& point) {
  const double size = surface.gradient(point).norm();
  const double distance = std::abs(surface.value(point)) / size;
  return std::isfinite(size) && std::isfinite(distance) ? distance
                                                        : std::numeric_limits<double>::infinity();
}

TrackedCircle circle_near(const ImplicitSurface& surface, const TravelRing& guess,
                          const Vec3& along) {
  const Circle middle = circle(surface, guess, along);
  // The rates by differences of the fourth order: where normals are at right angles to the axis, as
  // of canal surfaces, tilts change distances to the second order only, so that no Jacobian knows.
  const double step = middle.ring.radius / 16;
  const auto beside = [&](int steps) {
    TravelRing moved_on = middle.ring;
    moved_on.center += steps * step * along;
    return circle(surface, moved_on, along).ring;
  };
  const TravelRing before = beside(-1), far_before = beside(-2), after = beside(1),
                   far_after = beside(2);
  const auto rate = [&](const auto& of) {
    return ((8 * (of(after) - of(before)) - (of(far_after) - of(far_before))) / (12 * step)).eval();
  };
  const Vec3 center_rate = rate([](const TravelRing& ring) { return ring.center; });
  const Vec3 turning = rate([](const TravelRing& ring) { return ring.normal; });
  const Eigen::Matrix<double, 1, 1> growth = rate([](const TravelRing& ring) {
    return Eigen::Matrix<double, 1, 1>::Constant(ring.radius).eval();
  });
  const double speed = center_rate.norm();
  const Vec3& normal = middle.ring.normal;
  return {{middle.ring.center, normal, middle.ring.radius, center_rate / speed, growth[0] / speed,
           (turning - turning.dot(normal) * normal) / speed},
          middle.defect};
}

}  // namespace dupin::fitting
