#include "dupin/kernel/rounding.h"

namespace dupin {

// In a file of its own so that it is never inlined: GCC 12 at -O2 pairs two conversions to float
// and back into vectors and then drops both (its SLP vectoriser; clang gets it right).
double nearest(double value, Coordinates coordinates) {
  return coordinates == Coordinates::binary64 ? value
                                              : static_cast<double>(static_cast<float>(value));
}

}  // namespace dupin
