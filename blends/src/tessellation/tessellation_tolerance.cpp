#include "tessellation/tessellation_tolerance.h"

#include <algorithm>
#include <string>

#include "dupin/blends/tessellation.h"
#include "dupin/kernel/coordinates.h"
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
  return std::min(tolerance, kGreatestCoordinate) - displacement;  // all is coarse by then
}

std::uint32_t segment_count(double wanted) {
  constexpr std::uint32_t kFewest = 8;
  if (!(wanted <= kMostSegments)) {
    throw Error(Errc::limit_exceeded, "the tolerance asks for more than " +
                                          std::to_string(kMostSegments) +
                                          " segments around a ring; use a larger one");
  }
  return std::max(kFewest, std::uint32_t(std::ceil(wanted)));
}

std::string count_text(double count) {
  if (count < 1e6) {
    return decimal(std::round(count), kMessageDigits);
  }
  return count < 1e9 ? decimal(count / 1e6, 3) + " million" : decimal(count, 3);
}

void refuse_too_fine(double triangles) {
  if (!(triangles <= kMostTriangles)) {
    throw Error(Errc::limit_exceeded, "the tolerance asks for about " + count_text(triangles) +
                                          " triangles, more than " + count_text(kMostTriangles) +
                                          "; use a larger one, or smaller parts");
  }
}

}  // namespace dupin::tessellation
