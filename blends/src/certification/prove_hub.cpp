#include "certification/prove_hub.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>

#include <Eigen/Geometry>

#include "verification/claims/hub_claims.h"
#include "verification/work.h"

namespace dupin::certification {
namespace {

class Search {
 public:
  Search(const verification::Solid& arm, const Sphere& hub, std::size_t boxes)
      : arm_(arm), hub_(hub), left_(boxes) {}

  ClearanceClaim run() {
    ClearanceClaim result;
    if (!verification::begins_outside(arm_, hub_)) {
      return {};
    }
    for (double piece = 0; piece < arm_.length(); ++piece) {
      if (!prove({piece, piece + 1}, result)) {
        return {};
      }
    }
    result.verdict = Verdict::proved;
    return result;
  }

 private:
  bool prove(const ParameterInterval& t, ClearanceClaim& result) {
    constexpr double kShortest = 0x1p-40;
    if (left_ == 0 || t.to - t.from < kShortest) {
      return false;
    }
    --left_;
    if (verification::keeps_outside(arm_, t, hub_)) {
      result.leaves.push_back({t, {0, 1}, {}});
      return true;
    }
    const double middle = std::midpoint(t.from, t.to);
    return prove({t.from, middle}, result) && prove({middle, t.to}, result);
  }

  const verification::Solid& arm_;
  const Sphere& hub_;
  std::size_t left_;
};

double circumradius(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double area_twice = (b - a).cross(c - a).norm();
  return (b - a).norm() * (c - b).norm() * (a - c).norm() / (2 * area_twice);
}

}  // namespace

ClearanceClaim prove_at_hub(const verification::Solid& arm, const Sphere& hub, std::size_t boxes) {
  // What a search spends of the checker's work is none of the certificate's.
  const verification::WorkLimit limit(std::numeric_limits<std::uint64_t>::max());
  return Search(arm, hub, boxes).run();
}

MeshClaim hub_mesh_claim(const Sphere& hub, const TriMesh& mesh, std::uint32_t fewest_sides,
                         double grid) {
  double largest = 0;
  for (const Triangle& t : mesh.triangles) {
    largest =
        std::max(largest, circumradius(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]));
  }
  const double sine = std::min(1.0, largest * (1 + 0x1p-20) / hub.radius);
  const double segments = std::floor(std::numbers::pi / std::asin(sine));
  return {std::min(fewest_sides, std::uint32_t(segments)), grid, {}, 0};
}

}  // namespace dupin::certification
