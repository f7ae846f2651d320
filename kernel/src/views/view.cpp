#include "dupin/kernel/view.h"

#include <Eigen/Geometry>

#include "boxes/main_directions.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

// Scaled first, so that no square overflows or vanishes.
std::optional<Vec3> unit(const Vec3& vector) {
  const double largest = vector.cwiseAbs().maxCoeff();
  if (!vector.allFinite() || largest == 0) {
    return std::nullopt;
  }
  return (vector / largest).normalized();
}

}  // namespace

View view_along(const Vec3& direction, const std::optional<Vec3>& up) {
  const auto along = unit(direction);
  if (!along) {
    throw Error(Errc::invalid_argument, "a view needs a finite direction that is not zero");
  }
  constexpr double kNearlyAlong = 1e-9;  // the picture would turn with the last digits
  const auto right_of = [&](const Vec3& upwards) { return Vec3(along->cross(upwards)); };
  Vec3 right = right_of(Vec3::UnitZ());
  if (up) {
    const auto upwards = unit(*up);
    right = upwards ? right_of(*upwards) : Vec3(Vec3::Zero());
    if (right.norm() < kNearlyAlong) {
      throw Error(
          Errc::invalid_argument,
          "what is upwards in a view must be finite, not zero, and not the direction looked "
          "along");
    }
  } else if (right.norm() < kNearlyAlong) {
    right = right_of(Vec3::UnitY());
  }
  right.normalize();
  return {right, right.cross(*along), -*along};
}

std::optional<View> view_of_most(std::span<const Vec3> vectors) {
  const auto axes = boxes::axes_along_most({vectors.begin(), vectors.end()});
  return axes ? std::optional(View{axes->row(0), axes->row(1), axes->row(2)}) : std::nullopt;
}

}  // namespace dupin
