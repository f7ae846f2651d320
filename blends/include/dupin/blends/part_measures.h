#pragma once

#include <optional>
#include <string>

#include "dupin/blends/part_surface.h"

namespace dupin {

/// The volume of a solid and where it lies: with the density, what it weighs and how it balances.
struct SolidMoments {
  double volume = 0;
  Vec3 centroid = Vec3::Zero();
  /// The integral of (x - centroid)(x - centroid)^T over the solid.
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
};

/// Of two solids together, what they have in common counted twice; and of what is left of `a`
/// without a part `b` of it.
[[nodiscard]] SolidMoments operator+(const SolidMoments& a, const SolidMoments& b);
[[nodiscard]] SolidMoments operator-(const SolidMoments& a, const SolidMoments& b);

/// The inertia tensor about the centroid at density 1.
[[nodiscard]] Eigen::Matrix3d inertia(const SolidMoments& solid);

/// What a part measures, of the smooth surfaces and not of a mesh.
struct PartMeasures {
  double area = 0;               ///< of the outer surface, without end discs
  std::optional<double> length;  ///< of the curve of the discs' centres; none if there is no such
  /// Bounded by the surface and the end discs. None where no formula is at hand.
  std::optional<SolidMoments> solid;
  std::string missing;  ///< why there is none; empty if there is
};

/// Closed forms for cylinders, cones, balls, their joints, and the sections across; Gauss
/// quadrature along the pieces, whose panels are doubled until nothing changes beyond 1e-12 of the
/// integrals' size. A wall is not subtracted. Throws Error{limit_exceeded} where 64 panels do not
/// reach 1e-9.
[[nodiscard]] PartMeasures measures(const PartSurface& surface);

}  // namespace dupin
