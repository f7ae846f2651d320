#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "dupin/blends/cyclide_chain.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "numbers/angle.h"

namespace dupin {
namespace {

using std::numbers::pi;

double cap_area(double angle) { return 2 * pi * (1 - std::cos(angle)); }

double arc_cosine(double x) { return std::acos(std::clamp(x, -1.0, 1.0)); }

// Of two caps of angular radii a, b on the unit sphere, their axes c apart: by the angles of the
// triangle between the axes and a point where the circles meet.
double overlap(double a, double b, double c) {
  if (c >= a + b) {
    return 0;
  }
  if (c <= std::abs(a - b)) {
    return cap_area(std::min(a, b));
  }
  if (c >= 2 * pi - a - b) {  // together they cover the sphere
    return cap_area(a) + cap_area(b) - 4 * pi;
  }
  const auto angle = [](double opposite, double x, double y) {
    return arc_cosine((std::cos(opposite) - std::cos(x) * std::cos(y)) /
                      (std::sin(x) * std::sin(y)));
  };
  return 2 * (pi - angle(c, a, b) - std::cos(a) * angle(b, c, a) - std::cos(b) * angle(a, c, b));
}

}  // namespace

std::vector<PeArc> through_all(std::span<const PeVector> spheres,
                               const std::optional<PeVector>& tangent) {
  if (spheres.size() < 3 || spheres.size() % 2 == 0) {
    throw Error(Errc::invalid_argument,
                "pieces through three spheres each need an odd number of spheres, three at least, "
                "not " +
                    std::to_string(spheres.size()));
  }
  std::vector<PeArc> pieces;
  for (std::size_t i = 0; i + 2 < spheres.size(); i += 2) {
    try {
      pieces.push_back(i == 0 && tangent
                           ? PeArc::from(spheres[0], *tangent, spheres[2])
                           : through_three(spheres[i], spheres[i + 1], spheres[i + 2]));
    } catch (const Error& error) {
      throw PieceError(i / 2, error);
    }
  }
  return pieces;
}

// On the unit sphere the piece before touches along u.A = -tau and covers u.A < -tau, the piece
// after covers u.A > -tau; |A|^2 = 1 + tau^2.
SphericalJoint spherical_joint(const PeArc& before, const PeArc& after) {
  if (!(before.end() == after.start())) {
    throw Error(Errc::invalid_argument, "a kneecap needs pieces that meet in the same sphere");
  }
  const PeVector &arriving = before.end_tangent(), &leaving = after.start_tangent();
  SphericalJoint knee{before.end(), std::atan2(1, arriving.r), std::atan2(1, -leaving.r),
                      numbers::angle_between(-arriving.m, leaving.m)};
  const double common = overlap(knee.before, knee.after, knee.between);
  const double square = knee.sphere.r * knee.sphere.r;
  knee.overlap_area = square * common;
  knee.exposed_area = square * (4 * pi - cap_area(knee.before) - cap_area(knee.after) + common);
  return knee;
}

Chain kneecap_chain(std::span<const PeVector> spheres, const std::optional<PeVector>& tangent) {
  const std::vector<PeArc> arcs = through_all(spheres, tangent);
  for (std::size_t i = 1; i < arcs.size(); ++i) {
    const SphericalJoint knee = spherical_joint(arcs[i - 1], arcs[i]);
    if (knee.between <= std::abs(knee.before - knee.after)) {
      throw PieceError(
          i, Error(Errc::infeasible_blend,
                   "the piece turns back into the one before it: they leave their common sphere at "
                   "an angle of " +
                       decimal(knee.between * 180 / pi, 4) +
                       " degrees; move the spheres after it further round"));
    }
  }
  Chain chain;
  for (const PeArc& arc : arcs) {
    chain.pieces.emplace_back(cyclide_piece(arc));
  }
  chain.joints = Joints::spherical;
  return chain;
}

}  // namespace dupin
