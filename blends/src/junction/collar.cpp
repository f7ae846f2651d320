#include "junction/collar.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dupin::junction {

void Slides::sort() {
  if (count_ == 2 && lengths_[0] < lengths_[1]) {
    std::swap(lengths_[0], lengths_[1]);
  }
}

Slides slides(const PeVector& from, const PeVector& tangent, const PeVector& hub,
              double cap_cotangent) {
  const PeVector d = hub - from;
  const double g = cap_cotangent + tangent.r, along = product(d, tangent);
  const double squared = squared_tangential_distance(hub, from);
  const double a = 2 * tangent.r - g, half_b = g * along - tangent.r * along - d.r,
               c = 2 * along * d.r - g * squared;
  const double discriminant = half_b * half_b - a * c;
  if (!(discriminant >= 0)) {
    return {};
  }
  const double q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
  Slides result;
  for (const auto& [over, under] : {std::pair(q, a), std::pair(c, q)}) {
    if (under != 0) {
      result.add(over / under);
    }
  }
  result.sort();
  return result;
}

double cap_angle(const PeVector& from, const PeVector& tangent, const PeVector& hub) {
  const PeVector d = hub - from;
  const double cotangent =
      2 * product(d, tangent) / squared_tangential_distance(hub, from) * d.r - tangent.r;
  return std::atan2(1, cotangent);
}

double cap_share(double between, double thickness, double other_thickness, double widest) {
  const double own =
      std::atan2(std::sin(between) * thickness, other_thickness + thickness * std::cos(between));
  const double other = between - own;
  return std::min(widest, other > widest ? between - widest : own);
}

}  // namespace dupin::junction
