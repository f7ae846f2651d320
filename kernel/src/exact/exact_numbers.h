#pragma once

#include <array>

#include <CGAL/Mpzf.h>
#include <gmpxx.h>

#include "dupin/kernel/vec.h"
#include "exact/ball.h"

/// Numbers without rounding, the ground that every decision of the kernel stands on.
///
/// A double is an integer times a power of two, and so are sums, differences and products of
/// doubles: CGAL::Mpzf holds them all, and signs of determinants are asked of it (where a filter
/// in doubles could not tell, see predicates/). Quotients are rationals of GMP (mpq_class), but
/// points keep a common denominator instead (mesh/exact_mesh.h), so that nothing is ever reduced.
/// What leaves the kernel is rounded correctly, to the nearest double with ties to even, or
/// enclosed by two (dupin/kernel/enclosure.h). The rest of this folder: Ball, a number to about 100
/// bits (ball.h), FloatLattice, the numbers that a coordinate may be rounded to, ExactSum, long
/// sums of products of doubles (Kulisch's accumulator), and what needs no more than integers of
/// fixed width, as most coordinates are multiples of a power of two not far below them
/// (lattice_steps.h, line_plane_meeting.h). Numbers of any of these kinds make vectors in
/// vector_algebra.h.
namespace dupin::exact {

[[nodiscard]] mpq_class rational(const CGAL::Mpzf& number);

[[nodiscard]] CGAL::Mpzf integer(const mpz_class& number);

/// To about 100 bits; need rounding upward in the calling thread. Of a number beyond doubles
/// nothing is known.
[[nodiscard]] Ball ball(const CGAL::Mpzf& number);
[[nodiscard]] Ball ball(const mpq_class& number);

[[nodiscard]] inline int sign(const CGAL::Mpzf& value) { return static_cast<int>(value.sign()); }

struct ExactVector : std::array<CGAL::Mpzf, 3> {};

[[nodiscard]] inline ExactVector exact_vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

[[nodiscard]] inline ExactVector operator-(const ExactVector& a, const ExactVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

[[nodiscard]] inline ExactVector cross(const ExactVector& a, const ExactVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

[[nodiscard]] inline CGAL::Mpzf dot(const ExactVector& a, const ExactVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The double nearest to numerator / denominator (ties to even), for a positive denominator; the
/// fraction need not be in lowest terms. Infinite beyond the largest double.
[[nodiscard]] double nearest_double(const mpz_class& numerator, const mpz_class& denominator);
[[nodiscard]] double nearest_double(const mpq_class& value);

/// The neighbouring double: bounds a result that was rounded to the nearest.
[[nodiscard]] double next_below(double value);
[[nodiscard]] double next_above(double value);

}  // namespace dupin::exact
