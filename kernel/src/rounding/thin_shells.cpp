#include "rounding/thin_shells.h"

#include <cstdint>
#include <map>

#include <Eigen/Geometry>

#include "rounding/shell_check.h"

namespace dupin::rounding {
namespace {

struct Measures {
  double six_volumes = 0, two_areas = 0;

  /// None of a void or of what has no area.
  [[nodiscard]] double thickness() const { return 2 * (six_volumes / 6) / (two_areas / 2); }
};

std::vector<Measures> measures_of_shells(const mesh::ExactMesh& exact,
                                         const std::vector<std::uint32_t>& shell_of) {
  std::vector<Measures> result(exact.points.size());
  for (const auto& [a, b, c] : exact.triangles) {
    const std::uint32_t shell = shell_of[a];
    const Vec3 normal =
        (exact.points[b] - exact.points[a]).cross(exact.points[c] - exact.points[a]);
    result[shell].six_volumes += (exact.points[a] - exact.points[shell]).dot(normal);
    result[shell].two_areas += normal.norm();
  }
  return result;
}

}  // namespace

std::vector<MovedShell> thin_shells(const mesh::ExactMesh& exact, const PointMoves& moves,
                                    double longest) {
  if (longest == 0) {
    return {};
  }
  const std::vector<std::uint32_t> shell_of = shell_of_points(exact);
  const std::vector<Measures> measures = measures_of_shells(exact, shell_of);
  std::map<std::uint32_t, MovedShell> found;
  for (std::uint32_t i = 0; i < exact.points.size(); ++i) {
    const double thickness = measures[shell_of[i]].thickness();
    if (!(thickness > 0 && thickness < longest)) {
      continue;
    }
    const Vec3 shifted = exact.points[i] - moves.origin;
    const double move =
        moves.all_by > 0 ? moves.all_by : (moves.lattice.nearest(shifted) - shifted).norm();
    if (move > thickness && move > found[shell_of[i]].move) {
      found[shell_of[i]] = {exact.points[i], thickness, move};
    }
  }
  std::vector<MovedShell> result;
  for (const auto& [shell, thin] : found) {
    if (thin.move > 0) {
      result.push_back(thin);
    }
  }
  return result;
}

}  // namespace dupin::rounding
