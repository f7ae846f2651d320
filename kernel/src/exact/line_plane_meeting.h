#pragma once

#include <array>
#include <optional>

#include <CGAL/Mpzf.h>

#include "dupin/kernel/vec.h"

namespace dupin::exact {

/// Homogeneous coordinates, of a weight that is not negative, of the point where the line through p
/// and q meets the plane through a, b and c: with alpha and beta the determinants
/// det(b - a, c - a, p - a) and det(b - a, c - a, q - a), (p beta - q alpha, beta - alpha) or its
/// negative. By integers of fixed width. None if the lattice_steps of the five coordinates along
/// some axis are not whole, or not of between 2^-200 and 2^200.
///
/// Lemma: with the units of the axes 2^x, 2^y, 2^z, a determinant is an integer times 2^(x + y +
/// z), and a coordinate of the point one more unit of its axis. Steps are below 2^60 and
/// determinants below 2^186, so that coordinates are below 2^247.
[[nodiscard]] std::optional<std::array<CGAL::Mpzf, 4>> lattice_meeting(const Vec3& p, const Vec3& q,
                                                                       const Vec3& a, const Vec3& b,
                                                                       const Vec3& c);

/// The same of any coordinates; of weight 0 where the line does not meet the plane in a point.
[[nodiscard]] std::array<CGAL::Mpzf, 4> line_plane_meeting(const Vec3& p, const Vec3& q,
                                                           const Vec3& a, const Vec3& b,
                                                           const Vec3& c);

}  // namespace dupin::exact
