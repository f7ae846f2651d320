#include "dupin/blends/cyclide_tube.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "cyclide/arc_bounds.h"
#include "dupin/blends/cyclide_form.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using cyclide::ArcConstants;
using numbers::Interval;

// kappa R = r (kappa + |A x k|) / (1 + tau^2), a number per place.
Interval bend(const ArcConstants& arc, double from, double to) {
  const auto [r, tau, kappa] = cyclide::stretch(arc, from, to);
  return r * (kappa + arc.turning) / (Interval(1) + square(tau));
}

// The derivative of kappa R by the tangential length is tau (kappa + |A x k|) (1 - kappa R) /
// (1 + tau^2), where kappa + |A x k| never changes its sign: (A x k)^2 - kappa^2 = kk (1 + tau^2)
// vanishes nowhere, or everywhere. So kappa R is largest at an end or where tau = 0.
Interval largest_bend(const ArcConstants& arc, double from, double to) {
  const Interval ends = [&] {
    const Interval a = bend(arc, from, from), b = bend(arc, to, to);
    return Interval(std::max(a.lower, b.lower), std::max(a.upper, b.upper));
  }();
  const Interval tau = cyclide::stretch(arc, from, to).tau;
  if (tau.lower >= 0 || tau.upper <= 0) {
    return ends;
  }
  const double middle = (from + to) / 2;
  // Twenty halvings leave the error of a flat extremum below a unit of 2^-40.
  const double upper = bend(arc, from, to).upper;
  if (to - from < std::ldexp(1.0, -20) || upper <= ends.upper + std::ldexp(1.0, -40)) {
    return {ends.lower, std::max(ends.upper, upper)};
  }
  const Interval a = largest_bend(arc, from, middle), b = largest_bend(arc, middle, to);
  return {std::max(a.lower, b.lower), std::max(a.upper, b.upper)};
}

// Between the planes of the outer and the inner disc at an end, signed: positive where the inner
// disc lies further out.
double rim_volume(const Ring& outer, const Ring& inner) {
  const double height = (inner.center - outer.center).dot(outer.normal);
  const double a = outer.radius, b = inner.radius;
  return std::numbers::pi / 3 * height * (a * a + a * b + b * b);
}

// The circle at distance `wall` inwards along the normals of the cone of the ring's slope.
Ring inside(const Ring& ring, double wall) {
  const double stretch = std::hypot(1, ring.slope);
  return {ring.center + wall * ring.slope / stretch * ring.normal, ring.normal,
          ring.radius - wall / stretch, ring.slope};
}

}  // namespace

CyclideTube cyclide_tube(CyclideChain chain, double wall) {
  if (!(wall >= 0)) {
    throw Error(Errc::invalid_argument, "the wall's thickness must not be negative");
  }
  const Ring start = flipped(circle_at(chain.pieces.front(), 0));
  const Ring end = circle_at(chain.pieces.back(), 1);
  CyclideTube tube{start, end, std::move(chain), wall};
  for (std::size_t i = 0; wall > 0 && i < tube.chain.pieces.size(); ++i) {
    const double least = least_radius(tube.chain.pieces[i]);
    if (!(least > wall)) {
      throw Error(Errc::infeasible_blend,
                  "the wall of " + decimal(wall) +
                      " is no thinner than the least sphere, of radius " + decimal(least),
                  "piece " + std::to_string(i));
    }
  }
  if (wall > 0) {
    (void)inner_tube(tube);
  }
  return tube;
}

CyclideTube inner_tube(const CyclideTube& tube) {
  return {inside(tube.start, tube.wall), inside(tube.end, tube.wall),
          offset(tube.chain, -tube.wall), 0};
}

Enclosure margin(const PeArc& arc) {
  const ArcConstants constants(arc);
  // Cells in which the weights stay positive.
  constexpr int kCells = 32;
  Interval largest;
  for (int i = 0; i < kCells; ++i) {
    const Interval here =
        largest_bend(constants, cyclide::parameter_at(arc, static_cast<double>(i) / kCells),
                     cyclide::parameter_at(arc, (i + 1.0) / kCells));
    largest =
        i == 0 ? here
               : Interval(std::max(largest.lower, here.lower), std::max(largest.upper, here.upper));
  }
  const Interval result = Interval(1) - largest;
  return {result.lower, result.upper};
}

Enclosure margin(const CyclideTube& tube) {
  Enclosure least = margin(tube.chain.pieces.front());
  for (const PeArc& piece : tube.chain.pieces) {
    const Enclosure here = margin(piece);
    least = {std::min(least.lower, here.lower), std::min(least.upper, here.upper)};
  }
  return least;
}

// The walls differ by at most the angle between the axes and that between the half angles, which is
// at most the difference of their tangents. For a sine x <= 1/2 the angle is at most x (1 + x^2).
double tangency_bound(const CyclideTube& tube, SurfaceEnd end) {
  const bool at_start = end == SurfaceEnd::start;
  const Ring ring = at_start ? flipped(tube.start) : tube.end;
  const PeVector tangent =
      at_start ? tube.chain.pieces.front().start_tangent() : tube.chain.pieces.back().end_tangent();
  if (tangent == PeVector{ring.normal, ring.slope}) {
    return 0;
  }
  const auto axis = numbers::interval_vec(tangent.m), normal = numbers::interval_vec(ring.normal);
  const Interval sine =
      numbers::norm(numbers::cross(axis, normal)) / (numbers::norm(axis) * numbers::norm(normal));
  if (sine.upper > 0.5) {
    return std::numbers::pi;
  }
  const Interval angle = sine * (Interval(1) + square(sine));
  return (angle + Interval((Interval(tangent.r) - ring.slope).magnitude())).upper;
}

double area(const CyclideTube& tube) {
  double sum = tube.wall > 0 ? area(inner_tube(tube)) : 0;
  for (const PeArc& piece : tube.chain.pieces) {
    sum += area(piece);
  }
  return sum;
}

double volume(const CyclideTube& tube) {
  double sum = 0;
  for (const PeArc& piece : tube.chain.pieces) {
    sum += volume(piece);
  }
  if (tube.wall > 0) {
    const CyclideTube inner = inner_tube(tube);
    sum += rim_volume(tube.start, inner.start) + rim_volume(tube.end, inner.end) - volume(inner);
  }
  return sum;
}

std::string_view kind(const CyclideTube& tube) {
  constexpr std::array<std::string_view, 3> kNames{"single", "double", "triple"};
  const std::size_t pieces = tube.chain.pieces.size();
  return pieces <= kNames.size() ? kNames.at(pieces - 1) : "chain";
}

}  // namespace dupin
