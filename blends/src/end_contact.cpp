#include "dupin/blends/end_contact.h"

#include <cmath>

#include "dupin/kernel/error.h"
#include "second_derivatives.h"

namespace dupin {
namespace {

using detail::Interval;

// R'(0) or R'(1).
Interval end_slope(const RadiusLaw& law, bool at_end) {
  struct Visitor {
    bool at_end;
    Interval operator()(const ConstantRadius&) const { return 0; }
    Interval operator()(const CubicRadius&) const { return 0; }
    Interval operator()(const CyclideRadius&) const { return 0; }
    Interval operator()(const LinearRadius& l) const { return Interval(l.end) - l.start; }
    Interval operator()(const BezierRadius& l) const {
      const auto& c = l.coefficients;
      if (c.size() < 2) {
        return 0;
      }
      const std::size_t i = at_end ? c.size() - 2 : 0;
      return Interval(static_cast<double>(c.size() - 1)) * (Interval(c[i + 1]) - c[i]);
    }
  };
  return std::visit(Visitor{at_end}, law);
}

// With q = v - R e.T', x_t = q T + R' e has the slope R'/q against the axis; the cone has `slope`.
// The angle's tangent is (R' - slope q) / (q + slope R'). The normal curvature along x_t is
//   (q (q e.T' + R'') - R' (v' - 2 R' e.T' - R e.T'')) / (q^2 + R'^2)^(3/2).
EndContact contact(const RingedSurface& surface, bool at_end) {
  const double t = at_end ? 1 : 0;
  const double slope = at_end ? surface.end.slope : -surface.start.slope;
  const detail::SpineBounds y = detail::spine_bounds(surface.spine, t);
  const detail::RadiusBounds r = detail::radius_bounds(surface.radius, t);
  const Interval first = end_slope(surface.radius, at_end);
  const Interval bend = Interval(-1, 1) * Interval(y.turning);
  const Interval q = y.speed - Interval(r.value) * bend;
  const Interval meeting = q + Interval(slope) * first;
  if (!(q.lower > 0) || !(meeting.lower > 0)) {
    throw Error(Errc::irregular_surface, "the surface folds at its end ring", {},
                at_end ? "t = 1" : "t = 0");
  }
  // The quotient's numerator is monotone in q, so both ends of q's range are looked at alone.
  double tangent = 0;
  for (const Interval& end : {Interval(q.lower), Interval(q.upper)}) {
    const Interval ratio = (first - Interval(slope) * end) / (end + Interval(slope) * first);
    tangent = std::max(tangent, ratio.magnitude());
  }
  const Interval along = Interval(-1, 1) * Interval(y.acceleration) - Interval(2) * first * bend -
                         Interval(r.value) * Interval(-1, 1) * Interval(y.turning_change);
  const Interval numerator = q * (q * bend + Interval(-1, 1) * Interval(r.second)) - first * along;
  const Interval length2 = detail::square(q) + detail::square(first);
  const double jump = (numerator / (length2 * detail::sqrt(length2))).magnitude();
  // atan is correct to less than 2 ulp.
  return {std::nextafter(std::nextafter(std::atan(tangent), 4.0), 4.0), jump};
}

}  // namespace

EndContacts end_contacts(const RingedSurface& surface) {
  return {contact(surface, false), contact(surface, true)};
}

}  // namespace dupin
