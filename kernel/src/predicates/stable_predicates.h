#pragma once

#include <cmath>
#include <span>

#include "dupin/kernel/mesh.h"
#include "predicates/sign_filter.h"

/// What stays as it is wherever points move, each coordinate of each by at most a margin. Decided
/// in doubles, with bounds of the moves and of rounding: true or not 0 only if it is certain.
///
/// Lemma. A sign stays as long as points move by less than its determinant allows. As long as none
/// of the signs that a proof rests on changes, neither does what follows from them: which way
/// triangles turn, the order of edges around a point, how often a curve winds about a place, on
/// which side of a plane two triangles lie. So what keeps triangles apart
/// (checking/height_field_patches.h, checking/injective_stars.h, keep_apart below) keeps them apart
/// after any such move, the rounding of their points among them (mesh/stable_face_groups.h).
namespace dupin::predicates {

/// For the rounding of bounds and of differences between points, and for underflow.
inline constexpr double kStableMore = 1 + 0x1p-40, kStableUnderflow = 0x1p-900;

/// By how much u_i v_j - u_j v_i, in doubles, is off at most where the ends of u and v move.
[[nodiscard]] inline double error_of_cross(const Vec3& u, const Vec3& v, int i, int j,
                                           double margin) {
  const double rounding = kOrient2Bound * (std::abs(u[i] * v[j]) + std::abs(u[j] * v[i]));
  const double sizes = std::abs(u[i]) + std::abs(u[j]) + std::abs(v[i]) + std::abs(v[j]);
  return (rounding + 2 * margin * (sizes + 4 * margin)) * kStableMore + kStableUnderflow;
}

/// The sign of (b - a) x (p - a) seen along `axis`, if it stays; else 0.
[[nodiscard]] inline int stable_side_of_line(const Vec3& a, const Vec3& b, const Vec3& p, int axis,
                                             double margin) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Vec3 u = b - a, v = p - a;
  const double value = u[i] * v[j] - u[j] * v[i], bound = error_of_cross(u, v, i, j, margin);
  return (value > bound) - (value < -bound);
}

/// Whether the points stay off one line.
[[nodiscard]] bool keeps_area(const Vec3& a, const Vec3& b, const Vec3& c, double margin);

/// Whether the margin is so small that nearly all triangles, a sample tells, keep an area even with
/// several times as much. Else little stays, and to find out what takes long.
[[nodiscard]] bool is_small_margin(std::span<const Vec3> points,
                                   std::span<const Triangle> triangles, double margin);

/// Whether the triangles go on to meet in nothing but a corner or an edge that they share.
[[nodiscard]] bool keep_apart(std::span<const Vec3> points, const Triangle& s, const Triangle& t,
                              double margin);

}  // namespace dupin::predicates
