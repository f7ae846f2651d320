#include "meshing/unit_scale.h"

#include <cmath>
#include <utility>

#include "boxes/bounds.h"

namespace dupin::meshing {

double unit_for(const TriMesh& mesh) {
  const Eigen::AlignedBox3d box = boxes::bounds_of(mesh.points);
  const double extent = box.isEmpty() ? 0 : box.sizes().maxCoeff();
  return extent > 0 ? std::ldexp(1, std::ilogb(extent)) : 1;
}

CurvePoints in_unit(CurvePoints balls, double unit) {
  for (CurvePoint& ball : balls.points) {
    ball.place /= unit;
    ball.radius /= unit;
  }
  return balls;
}

Refinement in_unit(Refinement wanted, double unit) {
  wanted.edge_length = [length = std::move(wanted.edge_length), unit](const Vec3& point) {
    return length(point * unit) / unit;
  };
  wanted.radius /= unit;
  wanted.distance /= unit;
  for (Seed& seed : wanted.seeds) {
    seed.point /= unit;
  }
  return wanted;
}

}  // namespace dupin::meshing
