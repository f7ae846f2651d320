#include "dupin/kernel/coordinates.h"

namespace dupin {

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
