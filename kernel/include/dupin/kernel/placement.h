#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <gmpxx.h>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/solid.h"
#include "dupin/kernel/vec.h"

namespace dupin {

/// Where a body is put: any sequence of moves, turns and changes of size, each applied after those
/// before it. All in one it is x -> size * turn * x + shift, in rational numbers without rounding;
/// the turn is exactly one, so that shapes stay what they are. It is the very turn asked for if
/// that is by multiples of 90 degrees about an axis whose length is a double (those of
/// coordinates), or by 180 about any; else one that differs from it by less than kTurnError
/// radians.
class Placement {
 public:
  using Point = std::array<mpq_class, 3>;

  /// Of the sine and cosine of half the angle, and of the axis, in doubles.
  static constexpr double kTurnError = 0x1p-48;

  /// All throw Error{invalid_argument} for numbers that are not finite, no axis, and a factor that
  /// is not positive.
  void translate(const Vec3& by);
  void rotate(const Vec3& axis, double degrees, const Vec3& about = Vec3::Zero());
  void scale(double factor);
  /// By a ratio, which is taken as it is: 10 / 254 is no double.
  void scale(double factor, double divisor);

  [[nodiscard]] Point place(const Vec3& point) const;
  [[nodiscard]] Point turn(const Vec3& direction) const;
  [[nodiscard]] mpq_class scaled(double length) const;

  /// The matrix size * turn, row by row.
  [[nodiscard]] std::array<Point, 3> linear() const;
  [[nodiscard]] const Point& shift() const { return shift_; }

  /// Whether all turns are those that were asked for.
  [[nodiscard]] bool is_exact() const { return inexact_turns_ == 0; }
  /// How far points up to `radius` from the origin may be from where they were asked to be.
  [[nodiscard]] double error(double radius) const;

 private:
  struct Step {
    double shift = 0, factor = 1, turn_error = 0;
  };

  std::array<Point, 3> turn_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  mpq_class size_ = 1;
  Point shift_{0, 0, 0};
  std::vector<Step> steps_;
  std::size_t inexact_turns_ = 0;
};

/// The nearest doubles to the numbers.
[[nodiscard]] Vec3 nearest_point(const Placement::Point& point);

/// The solid there, in exact coordinates. Throws Error{invalid_argument} for coordinates that leave
/// their range (coordinates.h).
[[nodiscard]] Solid placed(const Solid& solid, const Placement& placement);

/// A mesh whose points were rounded to the nearest doubles.
struct PlacedMesh {
  TriMesh mesh;
  bool is_exact = true;  ///< no point was rounded
  double largest_move = 0;
};

/// Any mesh there. What of it was closed and free of self-intersection need not stay so. Throws
/// Error{invalid_argument} for coordinates that leave their range, or that of doubles if they were
/// not in it.
[[nodiscard]] PlacedMesh placed(const TriMesh& mesh, const Placement& placement);

}  // namespace dupin
