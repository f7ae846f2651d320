#include "surfaces/pieces/piece_measures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <Eigen/Geometry>

#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/elliptic_tube.h"
#include "dupin/kernel/error.h"
#include "numbers/quadrature.h"
#include "surfaces/cyclide_discs.h"

namespace dupin::surfaces {
namespace {

constexpr double kPi = std::numbers::pi;

// The ellipse center + xi first + eta second for xi^2 + eta^2 <= 1, and how it moves.
struct Section {
  Vec3 center, first, second;
  Vec3 velocity, normal, turning;  // unit normal; derivatives of center and normal
};

Section circle(const Vec3& center, double radius, const Vec3& velocity, const Vec3& normal,
               const Vec3& turning) {
  const Vec3 first = normal.unitOrthogonal();
  return {center, radius * first, radius * normal.cross(first), velocity, normal, turning};
}

// How the unit tangent of a spine turns.
Vec3 turning(const SpinePoint& y, const Vec3& tangent) {
  return (y.second - y.second.dot(tangent) * tangent) / y.first.norm();
}

// A spine about the origin, where derivatives of short ones do not drown in the rounding of places.
struct SpineFrom {
  Vec3 origin;

  Spine operator()(const LineSpine& line) const {
    return LineSpine{line.from - origin, line.to - origin};
  }
  Spine operator()(ArcSpine arc) const {
    arc.center -= origin;
    arc.start -= origin;
    return arc;
  }
  Spine operator()(HermiteSpine curve) const {
    curve.from -= origin;
    curve.to -= origin;
    return curve;
  }
  Spine operator()(BezierSpine curve) const {
    std::ranges::for_each(curve.points, [&](Vec3& point) { point -= origin; });
    return curve;
  }
};

using Sections = std::function<Section(double)>;

// Of a piece, which must outlive them.
struct SectionsOf {
  Vec3 origin;  // where they have theirs

  Sections operator()(const RingedSurface& tube) const {
    return [&tube, spine = std::visit(SpineFrom{origin}, tube.spine)](double t) {
      const SpinePoint y = evaluate(spine, t);
      const Vec3 tangent = y.first.normalized();
      return circle(y.position, evaluate(tube.radius, t).value, y.first, tangent,
                    turning(y, tangent));
    };
  }
  Sections operator()(const EllipticTube& at_its_place) const {
    EllipticTube tube = at_its_place;
    tube.spine = std::visit(SpineFrom{origin}, tube.spine);
    return [tube, field = frames(tube)](double t) {
      const SpinePoint y = evaluate(tube.spine, t);
      const Vec3 tangent = y.first.normalized();
      return Section{y.position,
                     evaluate(tube, field, t, 0).position - y.position,
                     evaluate(tube, field, t, kPi / 2).position - y.position,
                     y.first,
                     tangent,
                     turning(y, tangent)};
    };
  }
  Sections operator()(const CyclidePiece& piece) const {
    return [discs = CyclideDiscs(piece), from = origin](double t) {
      const auto disc = discs.over(numbers::Interval(t));
      if (!disc) {
        throw Error(Errc::irregular_surface, "the piece's discs stop within it");
      }
      return circle(middle(disc->center) - from, middle(disc->radius), middle(disc->velocity),
                    middle(disc->normal), middle(disc->turning));
    };
  }
  Sections operator()(const RationalRingedTube& tube) const {
    return [&tube, from = origin](double t) {
      const MovingRing ring = ring_at(tube.surface, t);
      return circle(ring.center - from, ring.radius, ring.center_rate, ring.normal,
                    ring.normal_rate);
    };
  }
};

// Volume, first moments, second moments (xx, yy, zz, xy, xz, yz), length.
using Integrals = Eigen::Matrix<double, 11, 1>;

// The section's points advance along the normal by an affine function of xi and eta, so that the
// integrals over it of polynomials are those of monomials over the unit disc: pi, pi / 4 of xi^2.
Integrals rates(const Section& s) {
  const double scale = s.first.cross(s.second).norm();
  const double s0 = s.velocity.dot(s.normal) * scale;
  const double s1 = -s.first.dot(s.turning) * scale, s2 = -s.second.dot(s.turning) * scale;
  const Vec3 &c = s.center, lean = s1 * s.first + s2 * s.second;
  const Eigen::Matrix3d second =
      kPi * s0 * c * c.transpose() +
      kPi / 4 *
          (s0 * (s.first * s.first.transpose() + s.second * s.second.transpose()) +
           lean * c.transpose() + c * lean.transpose());
  Integrals result;
  result << kPi * s0, kPi * s0 * c + kPi / 4 * lean, second.diagonal(), second(0, 1), second(0, 2),
      second(1, 2), s.velocity.norm();
  return result;
}

SolidMoments moments(const Integrals& sums, const Vec3& origin) {
  SolidMoments result;
  result.volume = sums[0];
  const Vec3 mean = sums.segment<3>(1) / sums[0];
  result.centroid = origin + mean;
  result.spread << sums[4], sums[7], sums[8], sums[7], sums[5], sums[9], sums[8], sums[9], sums[6];
  result.spread -= sums[0] * mean * mean.transpose();
  return result;
}

template <class Value, class Function>
Value integral(const Function& f, const numbers::Quadrature& rule) {
  Value sum = rule.weights.front() * f(rule.nodes.front());
  for (std::size_t i = 1; i < rule.nodes.size(); ++i) {
    sum += rule.weights[i] * f(rule.nodes[i]);
  }
  return sum;
}

// Of a cylinder or a cone the rates are polynomials of degree 4 at most, which three points of
// Gauss integrate exactly.
bool is_cone(const Piece& piece) {
  const auto* const tube = std::get_if<RingedSurface>(&piece);
  return tube != nullptr && std::holds_alternative<LineSpine>(tube->spine) &&
         is_linear(tube->radius);
}

const numbers::Quadrature& three_points() {
  static const double off = std::sqrt(0.15);
  static const numbers::Quadrature rule{{0.5 - off, 0.5, 0.5 + off}, {5. / 18, 8. / 18, 5. / 18}};
  return rule;
}

// Doubles the panels until neither the volume and moments, by the size of the piece, nor the length
// change.
template <class Value, class Function, class Distance>
Value converged(const Function& f, const Distance& distance) {
  constexpr double kWanted = 1e-12, kEnough = 1e-9;
  constexpr int kMostPanels = 64;
  static const numbers::Quadrature first = numbers::gauss_panels(1);
  Value last = integral<Value>(f, first);
  for (int panels = 2;; panels *= 2) {
    Value next = integral<Value>(f, numbers::gauss_panels(panels));
    const double change = distance(last, next);
    if (change <= kWanted || (panels == kMostPanels && change <= kEnough)) {
      return next;
    }
    if (panels == kMostPanels) {
      throw Error(Errc::limit_exceeded,
                  "its volume and moments are not found to 1e-9 by 64 panels of Gauss quadrature");
    }
    last = next;
  }
}

// By the volume, the length of the piece's extent, and the length.
double change(const Integrals& a, const Integrals& b) {
  const double size = std::sqrt((b[4] + b[5] + b[6]) / b[0]);
  const Integrals d = (a - b).cwiseAbs();
  return std::max({d[0] / b[0], d.segment<3>(1).maxCoeff() / (b[0] * size),
                   d.segment<6>(4).maxCoeff() / (b[0] * size * size), d[10] / b[10]});
}

struct AreaOf {
  double operator()(const RingedSurface& tube) const { return area(tube); }
  double operator()(const CyclidePiece& piece) const { return area(arc_of(piece)); }
  double operator()(const RationalRingedTube& tube) const { return area(tube.surface); }
  // The trapezoid rule around, which converges geometrically.
  double operator()(const EllipticTube& tube) const {
    constexpr int kAngles = 256;
    const FrameField field = frames(tube);
    return converged<double>(
        [&](double t) {
          double sum = 0;
          for (int i = 0; i < kAngles; ++i) {
            const SurfacePoint point = evaluate(tube, field, t, 2 * kPi * i / kAngles);
            sum += point.along.cross(point.around).norm();
          }
          return 2 * kPi / kAngles * sum;
        },
        [](double a, double b) { return std::abs(a - b) / b; });
  }
};

}  // namespace

PartMeasures measures(const Piece& piece) {
  const Vec3 origin = end_ring(piece, End::start).center;
  const Sections section = std::visit(SectionsOf{origin}, piece);
  const auto rates_at = [&](double t) { return rates(section(t)); };
  const auto sums = is_cone(piece) ? integral<Integrals>(rates_at, three_points())
                                   : converged<Integrals>(rates_at, change);
  return {std::visit(AreaOf{}, piece), sums[10], moments(sums, origin), {}};
}

// Of a segment of the ball the discs at height z, whose radius squared is r^2 - z^2.
SolidMoments cut_ball(const Sphere& ball, const std::vector<CutPlane>& cuts) {
  const double r = ball.radius, r2 = r * r;
  SolidMoments result{4 * kPi / 3 * r2 * r, ball.center,
                      4 * kPi / 15 * r2 * r2 * r * Eigen::Matrix3d::Identity()};
  for (const CutPlane& cut : cuts) {
    const double h = cut.height;
    const auto power = [&](int n) { return (std::pow(r, n) - std::pow(h, n)) / n; };
    const double volume = kPi * (r2 * power(1) - power(3));
    const double first = kPi * (r2 * power(2) - power(4));
    const double along = kPi * (r2 * power(3) - power(5));
    const double across = kPi / 4 * (r2 * r2 * power(1) - 2 * r2 * power(3) + power(5));
    const double mean = volume > 0 ? first / volume : 0;
    const Eigen::Matrix3d axis = cut.direction * cut.direction.transpose();
    result = result - SolidMoments{volume, ball.center + mean * cut.direction,
                                   across * (Eigen::Matrix3d::Identity() - axis) +
                                       (along - volume * mean * mean) * axis};
  }
  return result;
}

}  // namespace dupin::surfaces
