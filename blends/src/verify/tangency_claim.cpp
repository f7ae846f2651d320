#include <algorithm>

#include "../mpfi_interval.h"
#include "claims.h"

namespace dupin::verifier {
namespace {

using Mpfi = detail::MpfiInterval<1024>;
using MpfiVec = std::array<Mpfi, 3>;

Mpfi dot(const MpfiVec& a, const MpfiVec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Mpfi length_of_cross(const MpfiVec& a, const MpfiVec& b) {
  const MpfiVec c{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  return square_root(dot(c, c));
}

struct EndMotion {
  MpfiVec first, second;
};

EndMotion motion_at(const Tube& tube, bool at_end) {
  EndMotion result;
  if (const ArcSpine* arc = tube.arc()) {
    const Mpfi turned = at_end ? arc->angle : 0, rate = arc->angle;
    const Mpfi c = cosine(turned), s = sine(turned);
    MpfiVec u, a;
    for (int k = 0; k < 3; ++k) {
      u[k] = Mpfi(arc->start[k]) - arc->center[k];
      a[k] = arc->axis[k];
    }
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const Mpfi v = a[i] * u[j] - a[j] * u[i];
      result.first[k] = rate * (c * v - s * u[k]);
      result.second[k] = Mpfi(0) - rate * rate * (c * u[k] + s * v);
    }
    return result;
  }
  // Exactly, from w y = p.
  const Stretch s = tube.stretch(0, 1);
  const auto value = [at_end](const Polynomial& p) { return at_end ? p.back() : p.front(); };
  const Polynomial w1 = derivative(s.weight);
  const mpq_class w = value(s.weight);
  for (std::size_t k = 0; k < 3; ++k) {
    const Polynomial p1 = derivative(s.points[k]);
    const mpq_class y = value(s.points[k]) / w, y1 = (value(p1) - value(w1) * y) / w;
    const mpq_class y2 =
        (value(derivative(p1)) - 2 * value(w1) * y1 - value(derivative(w1)) * y) / w;
    result.first[k] = Mpfi(y1);
    result.second[k] = Mpfi(y2);
  }
  return result;
}

}  // namespace

bool follows(const Tube& tube, const TangencyClaim& claim, bool at_end) {
  const EndMotion y = motion_at(tube, at_end);
  const Ring& ring = at_end ? tube.surface().end : tube.surface().start;
  const Mpfi outward = at_end ? 1 : -1, slope = outward * ring.slope;
  const MpfiVec normal{outward * ring.normal.x(), outward * ring.normal.y(),
                       outward * ring.normal.z()};
  const Polynomial radius = tube.radius(0, 1);
  const Polynomial slopes = radius.empty() ? Polynomial{0} : derivative(radius);
  const Mpfi rise{at_end ? slopes.back() : slopes.front()};
  const Mpfi reach = evaluate(tube.surface().radius, at_end ? 1 : 0).value;
  const Mpfi speed = square_root(dot(y.first, y.first));
  const Mpfi bend = reach * length_of_cross(y.first, y.second) / square(speed);
  const auto deviation = [&](const Mpfi& advance) {
    return angle(magnitude(rise - advance * slope), advance + rise * slope).rounded_outward().upper;
  };
  const double largest = std::max(deviation(speed - bend), deviation(speed + bend));
  const double axis =
      angle(length_of_cross(y.first, normal), dot(y.first, normal)).rounded_outward().upper;
  return axis <= claim.axis_angle &&
         ((speed - bend).is_positive() ? largest : 4) <= claim.deviation;
}

}  // namespace dupin::verifier
