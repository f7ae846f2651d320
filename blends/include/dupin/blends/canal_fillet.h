#pragma once
#include <vector>
#include "dupin/blends/canal_patch.h"
namespace dupin {
struct RollingBall {
  Vec3 origin, x, y, z;
  double cosine = 0, sine = 1, d1 = 2, d2 = 1, h = 0, z1 = 0, side = 1, radius = 1;
};
struct CanalFillet {
  std::array<Ring, 2> quadrics;
  RollingBall motion;
};
[[nodiscard]] MovingBall ball(const CanalFillet& fillet, double parameter);
[[nodiscard]] double acceleration_bound(const CanalFillet& fillet, double from, double to);
[[nodiscard]] std::vector<CanalFillet> rolling_ball_fillets(const std::array<Ring, 2>& quadrics, double radius);
}  // namespace dupin
