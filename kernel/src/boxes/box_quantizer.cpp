#include "boxes/box_quantizer.h"

#include <cmath>
#include <limits>

#include "boxes/bounds.h"
#include "boxes/main_directions.h"
#include "support/blocks.h"

namespace dupin::boxes {
namespace {

/// Rounding to floats is monotone, but the products before it err, by less than 2^-48. Two ulps of
/// floats below 1, one of which is lost where they are added, are more than that.
constexpr float kRounding = 0x1p-23F;

}  // namespace

BoxQuantizer::BoxQuantizer(std::span<const Vec3> points) : BoxQuantizer(bounds_of(points)) {}

BoxQuantizer::BoxQuantizer(const Eigen::AlignedBox3d& bounds) : middle_(Vec3::Zero()), scale_(1) {
  if (bounds.isEmpty()) {
    return;
  }
  middle_ = bounds.min() / 2 + bounds.max() / 2;
  const double reach = (bounds.max() / 2 - bounds.min() / 2).maxCoeff();
  if (reach > 0) {
    // std::logb(reach) < log2(reach) + 1: the mapped points stay within (-1, 1).
    scale_ = std::exp2(std::clamp(-std::logb(reach) - 1, -1000.0, 1000.0));
  }
}

BoxQuantizer::BoxQuantizer(std::span<const Vec3> points, std::span<const Triangle> triangles)
    : BoxQuantizer(bounds_of(points), points, triangles) {}

BoxQuantizer::BoxQuantizer(const Eigen::AlignedBox3d& bounds, std::span<const Vec3> points,
                           std::span<const Triangle> triangles)
    : BoxQuantizer(bounds) {
  axes_ = main_directions(points, triangles);
  if (axes_) {
    scale_ /= 2;  // a point is at most sqrt(3) times as far from the middle along another axis
    rounding_ = kRounding;
  }
}

support::BulkVector<FramedPoint> BoxQuantizer::map(std::span<const Vec3> points) const {
  support::BulkVector<FramedPoint> mapped(points.size());
  support::for_each_block(points.size(), [&](const support::Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      mapped[i] = map(points[i]);
    }
  });
  return mapped;
}

Box BoxQuantizer::around(const Eigen::AlignedBox3d& box) const {
  Box all = Box::nothing();
  for (int i = 0; i < 8; ++i) {
    const FramedPoint corner = map(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
    all.join(around(FramedTriangle{corner, corner, corner}));
  }
  return all;
}

Box BoxQuantizer::around(const FramedTriangle& triangle, double margin) const {
  const float more = static_cast<float>(margin * scale_) + 2 * kRounding;
  Box box = around(triangle);
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] -= more;
    box.high[k] += more;
  }
  return box;
}

}  // namespace dupin::boxes
