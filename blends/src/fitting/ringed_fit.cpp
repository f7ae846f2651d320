#include "dupin/blends/ringed_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "dupin/blends/ringed_blend.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "fitting/circle_tracker.h"
#include "numbers/angle.h"

namespace dupin {
namespace {

using fitting::TrackedCircle;

TravelRing at_rest(const MovingRing& ring) { return {ring.center, ring.normal, ring.radius}; }

TravelRing at_rest(const Ring& ring) { return {ring.center, ring.normal, ring.radius}; }

void check(const Ring& ring) {
  if (!ring.center.allFinite() || !ring.normal.allFinite() ||
      !(std::abs(ring.normal.norm() - 1) < 1e-9) || !(ring.radius > 0) ||
      !std::isfinite(ring.radius) || ring.ellipse) {
    throw Error(Errc::invalid_argument,
                "a fit goes from circle to circle: centres must be finite, normals unit vectors, "
                "radii positive");
  }
}

// The blend of two circles, at the speeds of a circular arc between their centres.
RationalRingedSurface blend(const MovingRing& from, const MovingRing& to) {
  const double chord = (to.center - from.center).norm();
  const double turn = numbers::angle_between(from.center_rate, to.center_rate);
  const double length = chord * (1 + turn * turn / 24);
  return ringed_blend(at_speed(from, length), at_speed(to, length));
}

class Fitter {
 public:
  Fitter(const ImplicitSurface& surface, double tolerance)
      : surface_(surface), tolerance_(tolerance) {}

  RingedFit run(const Ring& from, const Ring& to) {
    TrackedCircle last = found(at_rest(from), from.normal);
    if (last.ring.center_rate.dot(from.normal) < 0) {
      refuse("the circles go against the first ring's normal", last);
    }
    for (bool is_last = false; !is_last;) {
      const TrackedCircle next = step(last, to, is_last);
      append(last, next, 0);
      last = next;
    }
    if ((last.ring.center - to.center).norm() > tolerance_ ||
        std::abs(last.ring.radius - to.radius) > tolerance_) {
      refuse("the tracked circles do not end in the last ring, whose centre is " +
                 decimal(to.center) + " and radius " + decimal(to.radius, kMessageDigits) +
                 ", but in one of radius " + decimal(last.ring.radius, kMessageDigits),
             last);
    }
    return std::move(result_);
  }

 private:
  [[noreturn]] void refuse(const std::string& why, const TrackedCircle& at) const {
    throw Error(Errc::infeasible_blend, why + " (at " + decimal(at.ring.center) + ")");
  }

  [[nodiscard]] TrackedCircle found(const TravelRing& guess, const Vec3& along) {
    TrackedCircle circle = fitting::circle_near(surface_, guess, along);
    if (!(circle.defect <= tolerance_)) {
      refuse("the surface is not ringed: the best circle is " +
                 decimal(circle.defect, kMessageDigits) + " off it, and the tolerance is " +
                 decimal(tolerance_, kMessageDigits),
             circle);
    }
    result_.circularity_defect = std::max(result_.circularity_defect, circle.defect);
    return circle;
  }

  // A quarter of the radius on, or in the last ring's plane where that is not farther.
  [[nodiscard]] TrackedCircle step(const TrackedCircle& from, const Ring& to, bool& is_last) {
    const MovingRing& ring = from.ring;
    const double length = ring.radius / 4;
    const double left = (to.center - ring.center).dot(to.normal);
    const double approach = ring.center_rate.dot(to.normal);
    is_last = left > 0 && left <= 1.5 * length * approach &&
              (to.center - ring.center).norm() <= 2 * (length + to.radius);
    const double way = is_last ? left / approach : length;
    TravelRing guess{ring.center + way * ring.center_rate,
                     (ring.normal + way * ring.normal_rate).normalized(),
                     ring.radius + way * ring.radius_rate};
    TrackedCircle next = found(guess, is_last ? to.normal : ring.center_rate);
    if (!(next.ring.center_rate.dot(ring.center_rate) > 0)) {
      refuse("the tracked circles turn back", next);
    }
    travelled_ += way;
    if (travelled_ > kMostRadii * ring.radius) {
      refuse("the tracked circles do not reach the last ring's plane", next);
    }
    return next;
  }

  [[nodiscard]] RationalRingedSurface blend_of(const TrackedCircle& from,
                                               const TrackedCircle& to) const {
    try {
      return blend(from.ring, to.ring);
    } catch (const Error& error) {
      if (error.code() != Errc::irregular_surface) {
        throw;
      }
      refuse("the surface is not ringed: the circles nearest to it turn too fast to be joined",
             from);
    }
  }

  void append(const TrackedCircle& from, const TrackedCircle& to, int depth) {
    const RationalRingedSurface surface = blend_of(from, to);
    const double its_error = error(surface, 16, 24);
    if (its_error > tolerance_ && depth < kMostHalvings) {
      const MovingRing middle = ring_at(surface, 0.5);
      const TrackedCircle between = found(at_rest(middle), middle.center_rate.normalized());
      append(from, between, depth + 1);
      append(between, to, depth + 1);
      return;
    }
    if (result_.pieces.size() == kMostPieces) {
      throw Error(Errc::limit_exceeded, "more than " + std::to_string(kMostPieces) +
                                            " pieces are needed; ask for a larger tolerance");
    }
    result_.error = std::max(result_.error, its_error);
    if (its_error > tolerance_) {  // halving does not help
      refuse("the surface is not ringed: a blend between its circles is " +
                 decimal(its_error, kMessageDigits) + " off it",
             from);
    }
    result_.pieces.push_back({flipped(ring(from)), ring(to), surface});
  }

  static Ring ring(const TrackedCircle& circle) {
    const MovingRing& moving = circle.ring;
    return {moving.center, moving.normal, moving.radius};
  }

  [[nodiscard]] double error(const RationalRingedSurface& surface, int along, int around) const {
    double largest = 0;
    for (int i = 0; i <= along; ++i) {
      for (int k = 0; k < around; ++k) {
        const Vec3 point =
            evaluate(surface, double(i) / along, 2 * std::numbers::pi * k / around).position;
        largest = std::max(largest, fitting::first_order_distance(surface_, point));
      }
    }
    return largest;
  }

  static constexpr int kMostHalvings = 12;
  static constexpr std::size_t kMostPieces = 4096;
  static constexpr double kMostRadii = 1000;

  const ImplicitSurface& surface_;
  double tolerance_, travelled_ = 0;
  RingedFit result_;
};

}  // namespace

RingedFit fit_ringed(const ImplicitSurface& surface, const Ring& from, const Ring& to,
                     double tolerance) {
  fitting::require_functions(surface);
  check(from);
  check(to);
  if (!(tolerance > 0) || !std::isfinite(tolerance)) {
    throw Error(Errc::invalid_argument, "the tolerance of a fit must be positive and finite");
  }
  return Fitter(surface, tolerance).run(from, to);
}

}  // namespace dupin
