#include <cmath>

#include "dupin/blends/spine.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin {

BezierSpine two_cone_spine(const std::array<Vec3, 4>& vertices, const std::array<double, 3>& m,
                           const std::array<double, 3>& w) {
  for (const auto& weights : {m, w}) {
    for (const double weight : weights) {
      if (!(std::isfinite(weight) && weight > 0)) {
        throw Error(Errc::invalid_argument, "a ridge's weights must be positive numbers, not " +
                                                decimal(weight, kMessageDigits));
      }
    }
  }
  for (const Vec3& vertex : vertices) {
    if (!vertex.allFinite()) {
      throw Error(Errc::invalid_argument, "a cone's vertices must be finite");
    }
  }
  // In coordinates of the tetrahedron the cones are l2^2 m1 m3 = 4 m2^2 l1 l3 and
  // l1^2 w1 w3 = 4 w2^2 l0 l2; these multiples of the Bernstein polynomials solve both.
  return {{vertices.begin(), vertices.end()},
          {8 * m[1] * m[1] * w[0] * w[1], 16. / 3 * m[1] * m[1] * w[1] * w[1],
           8. / 3 * m[1] * m[1] * w[1] * w[2], m[0] * m[2] * w[2] * w[2]}};
}

}  // namespace dupin
