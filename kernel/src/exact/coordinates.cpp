#include "dupin/kernel/coordinates.h"

#include <algorithm>
#include <cmath>

#include "dupin/kernel/decimal.h"

namespace dupin {

bool is_in_range(double coordinate) {
  const double size = std::abs(coordinate);
  return size == 0 || (size >= kLeastCoordinate && size <= kGreatestCoordinate);
}

bool is_in_range(const Vec3& point) {
  return is_in_range(point.x()) && is_in_range(point.y()) && is_in_range(point.z());
}

std::string range_fault(const Vec3& point) {
  const auto fault =
      std::find_if(point.begin(), point.end(), [](double x) { return !is_in_range(x); });
  const auto axis = static_cast<std::size_t>(fault - point.begin());
  std::string text = "the x coordinate ";
  text[4] = "xyz"[axis];
  text += decimal(*fault, kMessageDigits) + ", which must be 0 or from ";
  text += decimal(kLeastCoordinate) + " to ";
  return text + decimal(kGreatestCoordinate) + " in size";
}

// Never inlined: GCC 12 at -O2 pairs two conversions to float and back into vectors and then drops
// both (its SLP vectoriser; clang gets it right).
[[gnu::noinline]] double nearest(double value, Coordinates coordinates) {
  return coordinates == Coordinates::binary64 ? value
                                              : static_cast<double>(static_cast<float>(value));
}

Vec3 nearest(const Vec3& point, Coordinates coordinates) {
  return point.unaryExpr([&](double value) { return nearest(value, coordinates); });
}

}  // namespace dupin
