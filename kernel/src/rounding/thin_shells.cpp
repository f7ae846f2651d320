#include "rounding/thin_shells.h"

#include <map>

#include <Eigen/Geometry>

#include "rounding/shell_sums.h"

namespace dupin::rounding {
namespace {

struct Measures {
  double six_volumes = 0, two_areas = 0;

  void add(const Measures& other) {
    six_volumes += other.six_volumes;
    two_areas += other.two_areas;
  }
  /// None of a void or of what has no area.
  [[nodiscard]] double thickness() const { return 2 * (six_volumes / 6) / (two_areas / 2); }
};

}  // namespace

std::vector<MovedShell> thin_shells(const mesh::ExactMesh& exact,
                                    std::span<const std::uint32_t> shell_of,
                                    const PointMoves& moves, double longest) {
  auto shells = sums_of_shells<Measures>(
      exact.triangles, shell_of, [&](std::uint32_t face, std::uint32_t shell) -> Measures {
        const auto& [a, b, c] = exact.triangles[face];
        const Vec3 normal =
            (exact.points[b] - exact.points[a]).cross(exact.points[c] - exact.points[a]);
        return {(exact.points[a] - exact.points[shell]).dot(normal), normal.norm()};
      });
  std::erase_if(shells, [longest](const auto& shell) {
    const double thickness = shell.second.thickness();
    return !(thickness > 0 && thickness < longest);
  });
  if (shells.empty()) {
    return {};
  }
  std::map<std::uint32_t, MovedShell> found;
  for (std::uint32_t i = 0; i < exact.points.size(); ++i) {
    const auto thin = shells.find(shell_of[i]);
    if (thin == shells.end()) {
      continue;
    }
    const double thickness = thin->second.thickness();
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
