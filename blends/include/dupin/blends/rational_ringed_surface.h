#pragma once

#include <array>
#include <vector>

#include "dupin/blends/ringed_surface.h"

namespace dupin {

/// A circle that moves: what a ringed surface's end is given by. `normal` points in the direction
/// of travel at both ends of a blend; the rates are derivatives by the blend's parameter.
struct MovingRing {
  Vec3 center = Vec3::Zero(), normal = Vec3::UnitZ();
  double radius = 1;
  Vec3 center_rate = Vec3::UnitZ();
  double radius_rate = 0;
  Vec3 normal_rate = Vec3::Zero();  ///< orthogonal to the normal
};

/// A circle at rest, with its normal in the direction of travel.
struct TravelRing {
  Vec3 center = Vec3::Zero(), normal = Vec3::UnitZ();
  double radius = 1;
};

/// The rates that make a ringed surface tangent to what ends in the ring [BL15]; `speed` > 0 is
/// free and shapes the blend.
///
/// Of a cylinder (slope 0), cone, torus or any canal surface whose tangent cone there has slope
/// tan(half angle) in the direction of travel. The normal may turn at any rate.
[[nodiscard]] MovingRing along_canal(const TravelRing& ring, double slope, double speed,
                                     const Vec3& normal_rate = Vec3::Zero());
/// Of the sphere about `center`; a circle of it. Throws Error{invalid_argument} if the centre is
/// not on the ring's axis to 1e-9 of its radius.
[[nodiscard]] MovingRing along_sphere(const TravelRing& ring, const Vec3& center, double speed);
/// Of the cone with this apex, oblique or right: widening if the apex lies behind the ring.
[[nodiscard]] MovingRing along_oblique_cone(const TravelRing& ring, const Vec3& apex, double speed);
/// Of the cylinder with rulings along `direction`, oblique or right.
[[nodiscard]] MovingRing along_oblique_cylinder(const TravelRing& ring, const Vec3& direction,
                                                double speed);
/// Of the plane of the ring itself: growing into the hole, or closing to it if speed < 0.
[[nodiscard]] MovingRing along_plate(const TravelRing& ring, double speed);

/// Circles of radius rho(t) about d(t), in planes orthogonal to n(t) = A i A*, all rational: d and
/// rho are Bezier cubics, A a quaternion Bezier curve of degree 1 or 3 [BL15]. Its tangent plane is
/// continued from any of the surfaces above.
struct RationalRingedSurface {
  std::array<Vec3, 4> center;                   ///< Bezier points of d
  std::array<double, 4> radius;                 ///< Bezier coefficients of rho
  std::vector<std::array<double, 4>> rotation;  ///< Bezier points (w, x, y, z) of A
};

/// x(t, v) with the closed-form normal, outward where the discs do not overlap.
[[nodiscard]] SurfacePoint evaluate(const RationalRingedSurface& surface, double t, double v);

/// The ring at t with its rates.
[[nodiscard]] MovingRing ring_at(const RationalRingedSurface& surface, double t);

/// d'.n - rho |n'| (n unit): positive if and only if the discs near t do not overlap.
[[nodiscard]] double disc_margin(const RationalRingedSurface& surface, double t);

/// Whether rho > 0 and rho |n'| < (1 - margin) d'.n on [0, 1], decided by Bernstein subdivision of
/// the exact polynomials; false also where that does not decide within 40 halvings. At an end where
/// the circle stands still and its radius alone moves, as it does out of a plate, the inequality
/// holds in the limit.
[[nodiscard]] bool proves_regular(const RationalRingedSurface& surface, double margin = 0);

/// The largest multiple of 1/256 that is a proven lower bound of min(1 - rho |n'| / d'.n), which
/// for normal ringed surfaces is min(1 - kappa R). 0 for what is regular, but barely.
[[nodiscard]] double certified_margin(const RationalRingedSurface& surface);

[[nodiscard]] double area(const RationalRingedSurface& surface);
/// Swept by the discs.
[[nodiscard]] double volume(const RationalRingedSurface& surface);

/// The tangent blend of bidegree (9, 2) between two moving rings. Throws Error{invalid_argument}
/// for bad numbers, Error{infeasible_blend} for opposite normals (put a ring between), and
/// Error{irregular_surface} if its discs are not proven to be disjoint locally.
[[nodiscard]] RationalRingedSurface ringed_blend(const MovingRing& from, const MovingRing& to);

/// An end in contact with a canal surface: see along_canal.
struct CanalEnd {
  TravelRing ring;
  double slope = 0, speed = 1;
};

/// The tangent blend of bidegree (5, 2) between canal surfaces; throws as ringed_blend.
[[nodiscard]] RationalRingedSurface canal_ringed_blend(const CanalEnd& from, const CanalEnd& to);

/// A rational Bezier patch exactly: net[i][j] holds (x w, y w, z w, w), i along, j around.
struct RationalPatch {
  std::vector<std::array<std::array<double, 4>, 3>> net;
};

/// The part of the surface between the angles v0 < v1 < v0 + pi.
[[nodiscard]] RationalPatch rational_patch(const RationalRingedSurface& surface, double v0,
                                           double v1);

/// A patch's point; t along and s around, both in [0, 1].
[[nodiscard]] Vec3 evaluate(const RationalPatch& patch, double t, double s);

}  // namespace dupin
