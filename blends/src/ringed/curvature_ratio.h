#pragma once

#include <optional>
#include <utility>

#include "curves/exact_radius.h"
#include "dupin/blends/ringed_surface.h"
#include "numbers/interval.h"
#include "numbers/polynomial.h"

// Ringed surfaces: circles of radius R(t) about y(t), in planes orthogonal to y' [MS06] eq. (1), to
// ellipses' axes that turn (elliptic_tube.h), or to a normal n(t) of its own [BL15]. With v = |y'|,
// the unit tangent T, the curvature kappa and a direction e in the circle's plane, the surface
// moves by x_t = (v - R e.T') T + R' e: it is regular, and its discs do not overlap locally,
// exactly where kappa R < 1 [MS06] eq. (11). The margin is the minimum of 1 - kappa R; for other
// planes that of 1 - R |n'| / (y'.n). Here kappa^2 R^2 is a quotient of exact polynomials, and
// bounds of it are those of Bernstein coefficients; regularity.cpp halves [0, 1] with them. What
// triangles and knots may miss comes from bounds of second derivatives [FMM86]
// (second_derivatives.h), how ends meet their neighbours from tangency.cpp; blend_search.h chooses
// end speeds.
namespace dupin::ringed {

/// kappa^2 as a quotient of exact polynomials.
struct SquaredCurvature {
  numbers::Polynomial numerator, denominator;
};

/// |y' x y''|^2 / |y'|^6 up to a common factor; constants for lines and nominal arcs. The
/// denominator is positive exactly where the spine moves.
[[nodiscard]] SquaredCurvature squared_curvature(const Spine& spine);

/// (kappa R)^2, enclosed on dyadic subintervals of [0, 1]. The spine is exact; the radius too where
/// it is a polynomial (it is then part of the numerator), else it is replaced by linear bounds.
class CurvatureRatio {
 public:
  /// A subinterval with the Bernstein coefficients of numerator and denominator on it, in the same
  /// scale.
  struct Leaf {
    double from = 0, to = 1;
    int depth = 0;
    numbers::Bernstein numerator, denominator;
    numbers::Interval start_radius, end_radius;  // only for laws that are no polynomials
  };

  explicit CurvatureRatio(const RingedSurface& surface);

  [[nodiscard]] const Leaf& whole() const { return whole_; }
  [[nodiscard]] std::pair<Leaf, Leaf> split(const Leaf& leaf) const;

  /// Bounds of the ratio on the leaf; [0, inf] where the velocity might vanish.
  [[nodiscard]] numbers::Interval range(const Leaf& leaf) const;
  /// The ratio at the leaf's end points; [inf, inf] where the velocity vanishes.
  [[nodiscard]] numbers::Interval at_start(const Leaf& leaf) const;
  [[nodiscard]] numbers::Interval at_end(const Leaf& leaf) const;

  /// Whether ratio < bound everywhere on the leaf; exact for polynomial radii.
  [[nodiscard]] bool proves_below(const Leaf& leaf, const mpq_class& bound) const;
  /// Whether ratio >= bound at an end of the leaf; exact for polynomial radii.
  [[nodiscard]] bool refutes_below(const Leaf& leaf, const mpq_class& bound) const;

 private:
  // The numerator with the radius, binomially scaled and to be multiplied by 2^exponent.
  struct Scaled {
    numbers::Bernstein coefficients;
    long exponent = 0;
  };
  struct Line {
    double start = 0, end = 0;
  };

  [[nodiscard]] Scaled with_radius(const Leaf& leaf, const Line& radius) const;
  [[nodiscard]] Scaled upper_numerator(const Leaf& leaf) const;
  [[nodiscard]] Scaled lower_numerator(const Leaf& leaf) const;
  [[nodiscard]] double bulge(const Leaf& leaf) const;

  std::optional<CyclideRadius> law_;  // the radius, unless it is in the numerator
  double second_derivative_bound_ = 0;
  Leaf whole_;
};

}  // namespace dupin::ringed
