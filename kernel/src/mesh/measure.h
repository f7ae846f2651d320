#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <gmpxx.h>

#include "mesh/exact_mesh.h"

namespace dupin::mesh {

/// The volume that the triangles enclose, counted by winding: a sixth of the sum of the
/// determinants of their corners. O(n) where all coordinates are doubles; with n implicit points
/// the common denominator has O(n) digits.
[[nodiscard]] mpq_class exact_volume(const MeshView& mesh);

/// The double nearest to exact_volume, by enclosures that need no common denominator. O(n).
[[nodiscard]] double nearest_volume(const MeshView& mesh);

/// The sign of exact_volume, of closed triangles, likewise; from doubles, or from numbers to 100
/// bits, where these leave no doubt.
[[nodiscard]] int volume_sign(const MeshView& mesh);

/// The sum of the areas of the triangles; relative error below 1e-12.
[[nodiscard]] double area(const MeshView& mesh);

/// Added up with what rounding takes from it [Kahan].
class CompensatedSum {
 public:
  void add(double term) {
    const double rest = term - rest_, next = sum_ + rest;
    rest_ = (next - sum_) - rest;
    sum_ = next;
  }
  [[nodiscard]] double value() const { return sum_; }

 private:
  double sum_ = 0, rest_ = 0;
};

/// The very number that area() gives for triangles that come one after the other.
class AreaSum {
 public:
  void add(const std::array<Vec3, 3>& corners);
  [[nodiscard]] double value() const;

 private:
  struct Sums {
    CompensatedSum doubled, error, careful;  // careful: of which no term is in doubt
  };
  static void add(const Sums& block, Sums& all);

  Sums all_, block_;
  std::size_t in_block_ = 0;
};

}  // namespace dupin::mesh
