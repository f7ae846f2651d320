#include "rounding/rounding_options.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "boxes/bounds.h"

namespace dupin::rounding {

void validate(const RoundingOptions& options) {
  int exponent = 0;
  if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance)) {
    throw Error(Errc::invalid_argument, "the rounding tolerance must be finite and not negative");
  }
  if (options.output_grid != 0 && !(options.output_grid > 0 && std::isfinite(options.output_grid) &&
                                    std::frexp(options.output_grid, &exponent) == 0.5)) {
    throw Error(Errc::invalid_argument,
                "the grid spacing must be 0 or a power of two, such as 0.0009765625 (2^-10)");
  }
  if (!options.origin.place.allFinite()) {
    throw Error(Errc::invalid_argument, "the origin must be finite");
  }
}

Vec3 chosen_origin(const RoundingOptions& options, std::span<const Vec3> points) {
  const Origin& origin = options.origin;
  if (origin.choice == Origin::Choice::keep || (points.empty() && !options.whole)) {
    return Vec3::Zero();
  }
  if (origin.choice == Origin::Choice::given) {
    return origin.place;
  }
  const Eigen::AlignedBox3d whole = options.whole ? *options.whole : boxes::bounds_of(points);
  const double extent = (whole.max() / 2 - whole.min() / 2).maxCoeff();
  const double step = extent > 0 ? std::exp2(std::ilogb(extent) - 3) : 0;
  Vec3 place = whole.min() / 2 + whole.max() / 2;
  for (double& coordinate : place) {
    coordinate = step > 0 ? std::nearbyint(coordinate / step) * step : coordinate;
  }
  return place;
}

double largest_of(const RoundingOptions& options, const Vec3& origin) {
  return options.whole ? std::max((options.whole->min() - origin).cwiseAbs().maxCoeff(),
                                  (options.whole->max() - origin).cwiseAbs().maxCoeff())
                       : 0;
}

Error unroundable_error(const Vec3& at, double tolerance, Coordinates coordinates, bool is_far) {
  std::ostringstream where, message;
  where << "(" << at.x() << ", " << at.y() << ", " << at.z() << ")";
  message << "no valid mesh with coordinates of the target format within the tolerance of "
          << tolerance << "; what would help: ";
  if (is_far) {
    message << "recentring (origin auto), ";
  }
  if (coordinates == Coordinates::binary32) {
    message << "a format that holds doubles (OFF, OBJ, PLY instead of STL), ";
  }
  message << "a larger tolerance";
  return Error(Errc::unroundable, message.str(), {}, where.str());
}

}  // namespace dupin::rounding
