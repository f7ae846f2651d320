#pragma once

#include <array>
#include <cstddef>

#include "dupin/blends/pe_arc.h"

namespace dupin::junction {

/// At most two lengths, the largest first.
class Slides {
 public:
  Slides() = default;
  void add(double length) { lengths_.at(count_++) = length; }
  void sort();

  [[nodiscard]] const double* begin() const { return lengths_.data(); }
  [[nodiscard]] const double* end() const { return lengths_.data() + count_; }
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] double operator[](std::size_t i) const { return lengths_.at(i); }

 private:
  std::array<double, 2> lengths_{};
  std::size_t count_ = 0;
};

/// How far along its own cone a pipe has to go on before its collar begins, so that this ends in a
/// cap whose angular radius has this cotangent; negative: back.
///
/// With D = hub - from = (o - m; R - r), g = cot(cap) + tau: the s with 2 (<D, T> - s)((R - r) - s
/// tau) = g (<D, D> - 2 s <D, T> + s^2). For cylinders on the way to the centre at the distance h,
/// h - s = (R - r) / tan(45 degrees - cap / 2).
[[nodiscard]] Slides slides(const PeVector& from, const PeVector& tangent, const PeVector& hub,
                            double cap_cotangent);

/// The angular radius of the cap in which the collar ends, for a valid one.
[[nodiscard]] double cap_angle(const PeVector& from, const PeVector& tangent, const PeVector& hub);

/// What two caps in directions so far apart may have, so that each is as wide as its pipe is thick
/// and there is a gap between them: the first one's angular radius, at most `widest`.
[[nodiscard]] double cap_share(double between, double thickness, double other_thickness,
                               double widest);

}  // namespace dupin::junction
