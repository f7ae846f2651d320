#include <cmath>

#include "drawing/contour_curves.h"
#include "dupin/blends/drawing.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/view.h"

namespace dupin {

std::vector<ContourCurve> contours(const PartSurface& surface, const Vec3& direction,
                                   double tolerance) {
  if (!(tolerance > 0) || !std::isfinite(tolerance)) {
    throw Error(Errc::invalid_argument, "the tolerance of contours must be positive and finite");
  }
  std::vector<ContourCurve> result;
  for (const auto& curve :
       drawing::contours_of(surface, view_along(direction).towards, tolerance)) {
    ContourCurve& own = result.emplace_back();
    own.reserve(curve.size());
    for (const auto& [position, normal, curvature] : curve) {
      own.push_back({position, normal, curvature});
    }
  }
  return result;
}

}  // namespace dupin
