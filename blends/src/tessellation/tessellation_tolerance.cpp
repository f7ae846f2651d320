#include "tessellation/tessellation_tolerance.h"

#include <string>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::tessellation {

double allowed_error(double tolerance, double displacement) {
  if (!(tolerance > 2 * displacement)) {
    throw Error(Errc::invalid_argument,
                "the tolerance " + decimal(tolerance, kMessageDigits) +
                    " is too small for coordinates of this size on a grid of this spacing: points "
                    "may be off by " +
                    decimal_at_most(displacement));
  }
  return tolerance - displacement;
}

std::uint32_t segment_count(double wanted) {
  constexpr std::uint32_t kFewest = 8, kMost = 1'000'000;
  if (!(wanted <= kMost)) {
    throw Error(Errc::limit_exceeded, "the tolerance asks for more than " + std::to_string(kMost) +
                                          " segments around a ring; use a larger one");
  }
  return std::max(kFewest, std::uint32_t(std::ceil(wanted)));
}

void refuse_too_fine(std::size_t triangles) {
  constexpr std::size_t kMost = 50'000'000;
  if (triangles > kMost) {
    throw Error(Errc::limit_exceeded, "the tolerance asks for " + std::to_string(triangles) +
                                          " triangles, more than " + std::to_string(kMost) +
                                          "; use a larger one, or smaller parts");
  }
}

}  // namespace dupin::tessellation
