#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "dupin/blends/canal_fillet.h"

// Loops of fillets of every kind of motion.
namespace dupin::test {

struct NamedLoop {
  std::string name;
  CanalFillet loop;
};

inline std::array<Ring, 2> cylinders(double ratio, double offset, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {Ring{{0, 0, 0}, {1, 0, 0}, 4, 0},
          Ring{{3, 0, 4 * offset}, {std::cos(angle), std::sin(angle), 0}, 4 * ratio, 0}};
}

/// General, touching and equal pipes, pipes that cross in part, cones, and balls that grow.
inline std::vector<NamedLoop> loops_of_all_kinds() {
  std::vector<NamedLoop> result;
  const auto add = [&](const std::string& name, const std::vector<CanalFillet>& loops) {
    for (std::size_t i = 0; i < loops.size(); ++i) {
      result.push_back({name + "_" + std::to_string(i), loops[i]});
    }
  };
  add("through", rolling_ball_fillets(cylinders(0.5, 0.25, 60), 0.4));
  add("touching", rolling_ball_fillets(cylinders(0.75, 0.25, 90), 0.3));
  add("equal", rolling_ball_fillets(cylinders(1, 0, 60), 0.5));
  add("partly", rolling_ball_fillets(cylinders(0.5, 0.75, 45), 0.2));
  const Ring pipe{{0, 0, 0}, {1, 0, 0}, 4, 0}, cone{{1, 0, 0}, {0, 0, 1}, 2, 0.1};
  add("cone", rolling_ball_fillets({pipe, cone}, 0.5));
  add("partly_cone", rolling_ball_fillets({Ring{{0, 0, 0}, {1, 0, 0}, 4, 0},
                                           Ring{{1, 3.2, 0}, Vec3(0.2, 0, 1).normalized(), 2, 0.1}},
                                          0.3));
  add("rational", {rational_fillet(cylinders(0.5, 0.1, 70), {0.4, 0.5, 0.45, 0.5}, 1)});
  add("parallel",
      rational_fillets(
          {Ring{{2.2, 0, 0.5}, {0, 0, 1}, 0.5, 0}, Ring{{0, 0, 0}, {0, 0, 1}, 5, -4.4 / 6}}, 0.2));
  return result;
}

/// The angle of a loop at a parameter of its certificate, in [-pi/2, 3 pi/2].
inline double angle_at(double t) {
  const double half = t < 1 ? 0 : 1;
  return 2 * std::atan2(t - half, 1 - (t - half)) + (half - 0.5) * std::numbers::pi;
}

}  // namespace dupin::test
