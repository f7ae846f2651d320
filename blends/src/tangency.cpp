#include "dupin/blends/tangency.h"

#include <algorithm>
#include <cmath>

namespace dupin {
namespace {

// In the direction of travel the wall rises by R' while it goes on by q = v (1 - kappa R cos th),
// so the surface makes an angle of atan2(R', q) with the axis. q is monotone in cos th, and the
// angle in q: the extremes are at the two ends of q's range.
double deviation(const RingedSurface& surface, double t, double half_angle) {
  const SpinePoint y = evaluate(surface.spine, t);
  const RadiusValue radius = evaluate(surface.radius, t);
  const double speed = y.first.norm(), bend = curvature(y) * radius.value;
  const auto angle = [&](double q) { return std::abs(std::atan2(radius.first, q) - half_angle); };
  return std::max(angle(speed * (1 - bend)), angle(speed * (1 + bend)));
}

}  // namespace

// The normals point out of the surface: against the direction of travel at the start.
Tangency tangency(const RingedSurface& surface) {
  return {deviation(surface, 0, std::atan(-surface.start.slope)),
          deviation(surface, 1, std::atan(surface.end.slope))};
}

}  // namespace dupin
