#include "exact/number_enclosure.h"

namespace dupin::exact {

// Mpzf's own conversion multiplies by a power of two that is never 0 where doubles are rounded
// upward: whatever is below 2^-1021 comes out as something below that, of the same sign.
std::pair<double, double> enclosure(const CGAL::Mpzf& number) {
  constexpr double kLeast = 0x1p-1020;
  const auto [low, high] = number.to_interval();
  if (low >= kLeast || high <= -kLeast) {
    return {low, high};
  }
  const auto side = number.sign();
  return {side == CGAL::NEGATIVE ? -kLeast : 0, side == CGAL::POSITIVE ? kLeast : 0};
}

}  // namespace dupin::exact
