#include "exact/float_lattice.h"

namespace dupin::exact {

double FloatLattice::shifted(double value, int count) const {
  const double sign = count < 0 ? -1 : 1;
  double moved = sign * value;
  for (int i = 0; i != count; i += static_cast<int>(sign)) {
    // Towards zero the step is that of the numbers just below.
    moved += moved < 0 ? step(std::nextafter(moved, 0)) : step(moved);
  }
  return sign * moved + 0.0;
}

}  // namespace dupin::exact
