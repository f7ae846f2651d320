#pragma once

#include <array>
#include <vector>

#include "dupin/blends/canal_fillet.h"

namespace dupin {

/// What a ball leaves uncovered that rolls round the crossing of two straight pipes outside of
/// both: a surface tangent to both along closed curves. The pipes' faces end there.
struct Fillet {
  /// Those of the balls' ways that lie on the pipes: one for a branch, two where a pipe passes
  /// through the other. All have the same quadrics.
  std::vector<CanalFillet> loops;
  /// Which ends of the first and second pipe lie inside the other one, and vanish.
  std::array<std::array<bool, 2>, 2> buried{};
};

}  // namespace dupin
