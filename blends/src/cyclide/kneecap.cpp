#include "dupin/blends/kneecap.h"

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

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

std::vector<PeArc> through_all(std::span<const PeVector> spheres) {
  if (spheres.size() < 3 || spheres.size() % 2 == 0) {
    throw Error(Errc::invalid_argument,
                "pieces through three spheres each need an odd number of spheres, three at least, "
                "not " +
                    std::to_string(spheres.size()));
  }
  std::vector<PeArc> pieces;
  for (std::size_t i = 0; i + 2 < spheres.size(); i += 2) {
    try {
      pieces.push_back(through_three(spheres[i], spheres[i + 1], spheres[i + 2]));
    } catch (const Error& error) {
      throw error.in_part("piece " + std::to_string(i / 2));
    }
  }
  return pieces;
}

// On the unit sphere the piece before touches along u.A = -tau and covers u.A < -tau, the piece
// after covers u.A > -tau; |A|^2 = 1 + tau^2.
Kneecap kneecap(const PeArc& before, const PeArc& after) {
  if (!(before.end() == after.start())) {
    throw Error(Errc::invalid_argument, "a kneecap needs pieces that meet in the same sphere");
  }
  const PeVector &arriving = before.end_tangent(), &leaving = after.start_tangent();
  Kneecap knee{before.end(), std::atan2(1, arriving.r), std::atan2(1, -leaving.r),
               angle_between(-arriving.m, leaving.m)};
  const double common = overlap(knee.before, knee.after, knee.between);
  const double square = knee.sphere.r * knee.sphere.r;
  knee.overlap_area = square * common;
  knee.exposed_area = square * (4 * pi - cap_area(knee.before) - cap_area(knee.after) + common);
  return knee;
}

KneecapChain kneecap_chain(std::span<const PeVector> spheres) {
  std::vector<PeArc> pieces = through_all(spheres);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const Kneecap knee = kneecap(pieces[i - 1], pieces[i]);
    if (knee.between <= std::abs(knee.before - knee.after)) {
      throw Error(Errc::infeasible_blend,
                  "the piece turns back into the one before it: they leave their common sphere at "
                  "an angle of " +
                      decimal(knee.between * 180 / pi, 4) +
                      " degrees; move the spheres after it further round",
                  "piece " + std::to_string(i));
    }
  }
  const Ring start = flipped(circle_at(pieces.front(), 0)), end = circle_at(pieces.back(), 1);
  return {start, end, std::move(pieces)};
}

Enclosure margin(const KneecapChain& chain) {
  Enclosure least = margin(chain.pieces.front());
  for (const PeArc& piece : chain.pieces) {
    const Enclosure here = margin(piece);
    least = {std::min(least.lower, here.lower), std::min(least.upper, here.upper)};
  }
  return least;
}

}  // namespace dupin
