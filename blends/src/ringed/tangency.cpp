#include "dupin/blends/tangency.h"

#include <algorithm>
#include <array>
#include <variant>

#include "dupin/kernel/error.h"
#include "numbers/mpfi_interval.h"

namespace dupin {
namespace {

// Products of four doubles of like size are exact in this, and so what vanishes in such terms comes
// out as exactly zero.
using Interval = numbers::MpfiInterval<1024>;
using IntervalVector = std::array<Interval, 3>;

IntervalVector wide(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

IntervalVector plus(const IntervalVector& a, const IntervalVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

IntervalVector minus(const IntervalVector& a, const IntervalVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

IntervalVector times(const Interval& s, const IntervalVector& v) {
  return {s * v[0], s * v[1], s * v[2]};
}

IntervalVector cross(const IntervalVector& a, const IntervalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Interval dot(const IntervalVector& a, const IntervalVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Interval length(const IntervalVector& a) {
  return square_root(square(a[0]) + square(a[1]) + square(a[2]));
}

/// First and second derivative of the spine at an end.
struct Motion {
  IntervalVector first, second;
};

Motion motion_at(const LineSpine& line, End) { return {minus(wide(line.to), wide(line.from)), {}}; }

Motion motion_at(const ArcSpine& arc, End end) {
  const IntervalVector u = minus(wide(arc.start), wide(arc.center)), v = cross(wide(arc.axis), u);
  const Interval speed = arc.angle, turned = end == End::start ? 0 : arc.angle;
  const IntervalVector along = minus(times(cosine(turned), v), times(sine(turned), u));
  const IntervalVector outward = plus(times(cosine(turned), u), times(sine(turned), v));
  return {times(speed, along), times(Interval(0) - square(speed), outward)};
}

Motion motion_at(const HermiteSpine& spine, End end) {
  const IntervalVector chord = times(6, minus(wide(spine.to), wide(spine.from)));
  const IntervalVector from = wide(spine.start_velocity), to = wide(spine.end_velocity);
  return end == End::start ? Motion{from, minus(chord, plus(times(4, from), times(2, to)))}
                           : Motion{to, minus(plus(times(2, from), times(4, to)), chord)};
}

Motion motion_at(const BezierSpine& spine, End end) {
  const auto degree = static_cast<double>(spine.points.size() - 1);
  const auto index = [&](std::size_t i) {
    i = std::min(i, spine.points.size() - 1);
    return end == End::start ? i : spine.points.size() - 1 - i;
  };
  const auto step = [&](std::size_t i) {
    return minus(wide(spine.points[index(i)]), wide(spine.points[index(0)]));
  };
  const auto weight = [&](std::size_t i) -> Interval {
    return spine.weights.empty() ? 1 : spine.weights[index(i)];
  };
  // W y'' = N'' - 2 W' y' - W'' y for y = N / W, at the curve's first point.
  const Interval pull = weight(1) / weight(0), next_pull = weight(2) / weight(0);
  const Interval forward = end == End::start ? 1 : -1;
  return {times(forward * degree * pull, step(1)),
          plus(times(degree * (degree - 1) * next_pull, step(2)),
               times(2 * degree * pull * (1 - degree * pull), step(1)))};
}

/// dR/dt at an end.
Interval radius_slope(const RadiusLaw& law, End end) {
  if (const auto* linear = std::get_if<LinearRadius>(&law)) {
    return Interval(linear->end) - linear->start;
  }
  const auto* bezier = std::get_if<BezierRadius>(&law);
  if (bezier == nullptr || bezier->coefficients.size() < 2) {
    return 0;
  }
  const auto& c = bezier->coefficients;
  const std::size_t last = c.size() - 1, i = end == End::start ? 1 : last;
  return static_cast<double>(last) * (Interval(c[i]) - c[i - 1]);
}

}  // namespace

Tangency tangency_at_end(const RingedSurface& surface, End end) {
  const bool at_start = end == End::start;
  const Motion motion =
      std::visit([end](const auto& spine) { return motion_at(spine, end); }, surface.spine);
  const Interval speed = length(motion.first);
  if (!speed.is_positive()) {
    throw Error(Errc::irregular_surface,
                "the spine stands still there, so the surface has no tangent; its end velocity "
                "must not be zero",
                {}, at_start ? "start" : "end");
  }
  // Both the ring's normal and its slope look out of the part, at the start against the spine.
  const Ring& ring = at_start ? surface.start : surface.end;
  const Interval outward = at_start ? -1 : 1;
  const IntervalVector normal = times(outward, wide(ring.normal));
  const Interval slope = outward * ring.slope;

  const Interval rise = radius_slope(surface.radius, end);
  const Interval bend = Interval(evaluate(surface.radius, at_start ? 0 : 1).value) *
                        length(cross(motion.first, motion.second)) / square(speed);
  // The angle between the surface's direction (advance, rise) and the wall's (1, slope), in one
  // step so that equal directions give exactly 0. atan2(rise, advance) is monotone in advance =
  // |y'|(1 - kappa R cos theta), so the largest difference is found where the cosine is 1 or -1.
  const auto deviation = [&](const Interval& advance) {
    return angle(magnitude(rise - advance * slope), advance + rise * slope).rounded_outward();
  };
  const Interval slowest = speed - bend;
  const Enclosure inner = deviation(slowest), outer = deviation(speed + bend);
  Enclosure largest{std::max(inner.lower, outer.lower), std::max(inner.upper, outer.upper)};
  if (!slowest.is_positive()) {  // folded: on the way round the directions may oppose each other
    largest.upper = Interval::pi().rounded_outward().upper;
  }
  return {largest,
          angle(length(cross(motion.first, normal)), dot(motion.first, normal)).rounded_outward(),
          (bend / speed).rounded_outward()};
}

}  // namespace dupin
