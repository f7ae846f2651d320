#pragma once

#include "dupin/blends/pe_arc.h"
#include "numbers/interval.h"
#include "ringed/second_derivatives.h"

namespace dupin::cyclide {

/// What is constant along a PE-arc by its tangential length, in intervals that hold the values for
/// the stored numbers. With ' the derivative by that length, T = (A; tau) the tangent and
/// K = (k; kappa) its derivative: K' = -kk T, and A x k is constant.
struct ArcConstants {
  explicit ArcConstants(const PeArc& arc);

  numbers::Interval w, chord;
  numbers::Interval curvature_squared;  ///< kk = <K, K> = 4 (1 - w^2) / L^2
  numbers::Interval turning;  ///< |A x k|: the spine's plane turns by |A x k| / (1 + tau^2)
  /// Homogeneous Bezier coefficients of r and tau, both over the weights (1, w, 1).
  std::array<numbers::Interval, 3> radius, tau;
  numbers::Interval start_radius, start_kappa;
};

/// r, tau and kappa over a stretch of the arc.
struct ArcStretch {
  numbers::Interval radius, tau, kappa;
};

/// Over the parameters [from, to] of the arc. Throws Error{irregular_surface} where the weight may
/// vanish.
[[nodiscard]] ArcStretch stretch(const ArcConstants& arc, double from, double to);

/// The parameter at a fraction of the arc's tangential length; 0 and 1 exactly.
[[nodiscard]] double parameter_at(const PeArc& arc, double fraction);

/// Bounds of the second derivatives of the surface by the fraction of the tangential length and the
/// angle around, in the frame that the symmetry plane carries along, over fractions [from, to].
[[nodiscard]] ringed::BandBounds band_bounds(const PeArc& arc, const ArcConstants& constants,
                                             double from, double to);

}  // namespace dupin::cyclide
