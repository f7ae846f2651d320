#include "cyclide/complementary_sphere.h"

#include <cmath>

namespace dupin::cyclide {

ComplementarySphere complementary_sphere(const PeArc& arc, const ArcFrame& frame, double kappa,
                                         double c, double s) {
  const double tau = arc.start_tangent().r, stretch = std::hypot(1, tau);
  const Vec3 u =
      (-kappa * tau / stretch) * frame.axis + (1 / stretch) * (c * frame.first + s * frame.second);
  const PeVector d = arc.end() - arc.start();
  const double e = -u.dot(d.m) - kappa * d.r, length2 = arc.chord() * arc.chord();
  return {2 * e * arc.start().m - length2 * u, 2 * e * arc.start().r + length2 * kappa, 2 * e};
}

}  // namespace dupin::cyclide
