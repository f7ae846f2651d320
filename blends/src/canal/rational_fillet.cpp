#include "canal/rational_fillet.h"

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "canal/quadric_pair.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using canal::QuadricPair;
using Vec4 = Eigen::Vector4d;

constexpr int kSamples = 128;  // of a loop, where what was asked for is looked at

Vec4 coordinates(const PeVector& v) { return {v.m.x(), v.m.y(), v.m.z(), v.r}; }

PeVector pe_vector(const Vec4& v) { return {v.head<3>(), v[3]}; }

/// The PE-unit vector orthogonal to three others: the spacelike one of both whose determinant with
/// them, in the third place, is positive.
PeVector completed(const PeVector& a, const PeVector& b, const PeVector& c) {
  Eigen::Matrix4d m;
  m << coordinates(a), coordinates(b), Vec4::Zero(), coordinates(c);
  Vec4 cofactors;
  for (int i = 0; i < 4; ++i) {
    m.col(2) = Vec4::Unit(i);
    cofactors[i] = m.determinant();
  }
  cofactors[3] = -cofactors[3];  // from the Euclidean product to the pseudo-Euclidean one
  const PeVector result = pe_vector(cofactors);
  return 1 / std::sqrt(product(result, result)) * result;
}

[[noreturn]] void refuse(const std::string& why) { throw Error(Errc::irregular_surface, why); }

[[noreturn]] void refuse_radius(double radius, double parameter) {
  refuse("no ball of radius " + decimal(radius, kMessageDigits) +
         " touches both quadrics at the parameter " + decimal(parameter, kMessageDigits) +
         " of such a fillet");
}

/// The g for which the ball at the parameter has this radius.
double size_for(const RationalCrossing& motion, double radius, double c, double s) {
  const double k = motion.origin.r + radius, d = motion.distance;
  const double cy = motion.side * (motion.cosine / motion.sine * motion.along.r + motion.across.r);
  const double a0 = k + d * (cy - motion.e4.r);
  const double a1 = -2 * k + 2 * d * (c / motion.sine * motion.along.r + s * motion.e3.r);
  const double a2 = s * s * (k - d * (cy + motion.e4.r));
  const double g = 2 * a0 / (-a1 + std::sqrt(a1 * a1 - 4 * a0 * a2));
  if (!(g > 0 && g * (1 + std::abs(c)) < 1)) {
    refuse_radius(radius, std::atan2(s, c));
  }
  return g;
}

RationalCrossing crossing(const QuadricPair& pair, const std::array<double, 4>& radii, int side) {
  const std::size_t one = canal::passed_through(pair), two = 1 - one;
  RationalCrossing motion;
  motion.distance = std::sqrt(-pair.squared_distance);
  motion.e4 = (one == 0 ? 1 : -1) / motion.distance * pair.apart;
  motion.origin = pair.nearest[one];
  motion.along = pair.along[one];
  motion.cosine = pair.cosine;
  motion.sine = std::sqrt(pair.squared_sine);
  motion.across = 1 / motion.sine * (pair.along[two] - pair.cosine * pair.along[one]);
  motion.e3 = completed(motion.along, motion.across, motion.e4);
  motion.side = side;
  const double g0 = size_for(motion, radii[0], 1, 0), g1 = size_for(motion, radii[1], 0, 1);
  const double g2 = size_for(motion, radii[2], -1, 0), g3 = size_for(motion, radii[3], 0, -1);
  motion.size = {(g0 + g1 + g2 + g3) / 4, (g0 - g2) / 2, (g1 - g3) / 2, (g0 - g1 + g2 - g3) / 4};
  return motion;
}

/// The unit timelike vector, towards larger spheres, of the plane of both directions and orthogonal
/// to the first of them.
PeVector timelike(const PeVector& first, const PeVector& second, const QuadricPair& pair) {
  const PeVector v = second - pair.cosine * first;
  return (v.r < 0 ? -1 : 1) / std::sqrt(-pair.squared_sine) * v;
}

RationalParallel around_first(const QuadricPair& pair, const std::array<double, 4>& radii) {
  const double size = std::abs(pair.nearest[0].r) + std::abs(pair.nearest[1].r);
  if (!(pair.squared_distance > 1e-18 * size * size)) {
    refuse("the quadrics share an axis: a ball between them runs around it and sweeps a torus");
  }
  RationalParallel motion;
  motion.half_distance = std::sqrt(pair.squared_distance) / 2;
  motion.ey = 1 / (2 * motion.half_distance) * pair.apart;
  motion.origin = 0.5 * (pair.nearest[0] + pair.nearest[1]);
  motion.nu1 = timelike(pair.along[0], pair.along[1], pair);
  motion.nu2 = timelike(pair.along[1], pair.along[0], pair);
  motion.product = product(motion.nu1, motion.nu2);
  motion.ez = completed(pair.along[0], motion.ey, motion.nu1);
  Eigen::Matrix4d m;
  m << coordinates(pair.along[0]), coordinates(motion.ey), coordinates(motion.ez), Vec4::Unit(3);
  if (m.determinant() < 0) {
    motion.ez = -1 * motion.ez;
  }
  // The radius at 0 is linear in u, that at pi in v.
  const double k = motion.product, h = motion.half_distance, rest = (1 - k) * (1 + k);
  const double p = (motion.nu1.r + k * motion.nu2.r) / rest;
  const double q = (motion.nu2.r + k * motion.nu1.r) / rest;
  const double u = (radii[0] + motion.origin.r + h * (p - q)) / (h * (p + q));
  const double v = (h * (p + q) - radii[2] - motion.origin.r) / (h * (p - q));
  motion.far_squared = (u - 1) / (u + 1);
  motion.near_squared = (1 - v) / (1 + v);
  if (!(u > 1)) {
    refuse_radius(radii[0], 0);
  }
  if (!(std::abs(v) < 1)) {
    refuse_radius(radii[2], std::numbers::pi);
  }
  return motion;
}

/// Throws unless the fillet is sound at this parameter.
void require_sound(const CanalFillet& fillet, double parameter) {
  const std::string where = " at the parameter " + decimal(parameter, kMessageDigits);
  const MovingBall at = ball(fillet, parameter);
  if (!(at.radius > 0)) {
    refuse("the fillet's ball has the radius " + decimal(at.radius, kMessageDigits) + where);
  }
  const ContactArc arc = contact_arc(fillet.quadrics, at);
  for (std::size_t i = 0; i < 2; ++i) {
    const Ring& quadric = fillet.quadrics[i];
    const double along = (arc.feet[i] - quadric.center).dot(quadric.normal);
    if (!(quadric.radius + quadric.slope * along > 0)) {
      refuse("the fillet's ball touches a cone beyond its apex" + where);
    }
  }
  if (const double regularity = least_regularity(at, arc); !(regularity > 0)) {
    refuse("the fillet folds" + where + ": its regularity there is " +
           decimal(regularity, kMessageDigits));
  }
}

}  // namespace

CanalFillet rational_fillet(const std::array<Ring, 2>& quadrics, const std::array<double, 4>& radii,
                            int side) {
  for (const double radius : radii) {
    canal::require_positive(radius);
  }
  if (side != 1 && side != -1) {
    throw Error(Errc::invalid_argument, "the side of a fillet is 1 or -1");
  }
  const QuadricPair pair = canal::quadric_pair(quadrics);
  CanalFillet fillet{quadrics, RationalCrossing{}};
  if (pair.squared_sine < 0) {
    fillet.motion = around_first(pair, radii);
  } else {
    const RationalCrossing motion = crossing(pair, radii, side);
    fillet.motion = motion;
    for (int k = 0; k < kSamples; ++k) {
      const double parameter = 2 * std::numbers::pi * k / kSamples;
      const double g = canal::size_jet(motion.size, canal::turn(parameter)).value;
      if (!(g > 0 && g * (1 + std::abs(std::cos(parameter))) < 1)) {
        refuse("the radii of the fillet's ball change too much around it");
      }
    }
  }
  for (int k = 0; k < kSamples; ++k) {
    require_sound(fillet, 2 * std::numbers::pi * k / kSamples);
  }
  return fillet;
}

std::vector<CanalFillet> rational_fillets(const std::array<Ring, 2>& quadrics, double radius) {
  const std::array<double, 4> radii{radius, radius, radius, radius};
  std::vector<CanalFillet> fillets{rational_fillet(quadrics, radii, 1)};
  if (std::holds_alternative<RationalCrossing>(fillets[0].motion)) {
    fillets.push_back(rational_fillet(quadrics, radii, -1));
  }
  return fillets;
}

}  // namespace dupin
