#include "gaps/face_boxes.h"

#include <cmath>
#include <limits>

namespace dupin::gaps {

FaceBoxIndex::FaceBoxIndex(const MeshPair& pair)
    : pair_(pair),
      frame_(pair.points),
      low_(Vec3::Constant(std::numeric_limits<double>::infinity())),
      high_(-low_),
      tree_(boxes_of_b()) {
  for (const Vec3& point : pair.points) {
    low_ = low_.cwiseMin(point);
    high_ = high_.cwiseMax(point);
  }
}

std::vector<boxes::Box> FaceBoxIndex::boxes_of_b() const {
  std::vector<boxes::Box> boxes;
  for (auto face = pair_.faces_of_a; face < pair_.triangles.size(); ++face) {
    const auto [a, b, c] = pair_.corners(face);
    boxes.push_back(pair_.flat[face] != 0 ? boxes::Box::nothing()
                                          : frame_.around(frame_.map(a, b, c)));
  }
  return boxes;
}

boxes::Box FaceBoxIndex::around(std::uint32_t face, double reach) const {
  const auto [a, b, c] = pair_.corners(face);
  // One ulp makes up for the rounding of the difference; the tree's own map is monotone. What lies
  // beyond all points need not be told apart.
  const auto down = [](double x) {
    return std::nextafter(x, -std::numeric_limits<double>::infinity());
  };
  const auto up = [](double x) {
    return std::nextafter(x, std::numeric_limits<double>::infinity());
  };
  const Vec3 margin = Vec3::Constant(reach);
  const Vec3 low = (a.cwiseMin(b).cwiseMin(c) - margin).unaryExpr(down).cwiseMax(low_);
  const Vec3 high = (a.cwiseMax(b).cwiseMax(c) + margin).unaryExpr(up).cwiseMin(high_);
  return frame_.around(frame_.map(low, high, high));
}

}  // namespace dupin::gaps
