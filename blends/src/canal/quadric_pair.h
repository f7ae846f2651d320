#pragma once

#include <array>

#include "dupin/blends/pe_arc.h"
#include "dupin/kernel/ring.h"

namespace dupin::canal {

/// Two lines of R^{3,1}, those of the spheres that touch two quadrics from inside: how they lie to
/// each other (mathematics B.1). Unlike the angle and distance of axes, these numbers do not change
/// when both quadrics are replaced by parallel ones.
struct QuadricPair {
  std::array<PeVector, 2> along;    ///< PE-unit directions
  std::array<PeVector, 2> nearest;  ///< their points with PE-orthogonal connection to the other
  PeVector apart;                   ///< nearest[0] - nearest[1]
  double cosine = 0;                ///< product of the directions
  double squared_sine = 1;          ///< 1 - cosine^2: negative where they span a timelike plane
  double squared_distance =
      0;  ///< product of `apart` with itself: negative where they cross in time
};

/// Throws Error{invalid_argument} for invalid or elliptic rings, Error{irregular_surface} where the
/// directions are equal or opposite: then any ball runs along both without end.
[[nodiscard]] QuadricPair quadric_pair(const std::array<Ring, 2>& quadrics);

/// The index of the quadric through which the other one passes. Throws Error{irregular_surface} if
/// there is none, or if they nearly touch from inside.
[[nodiscard]] std::size_t passed_through(const QuadricPair& pair);

/// Throws Error{invalid_argument} unless the rings are circular and valid.
void require_quadrics(const std::array<Ring, 2>& quadrics);

/// Throws Error{invalid_argument} unless the ball's radius is finite and positive.
void require_positive(double ball_radius);

}  // namespace dupin::canal
