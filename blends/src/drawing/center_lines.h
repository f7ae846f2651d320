#pragma once

#include <string>
#include <vector>

#include "dupin/blends/resolve.h"

namespace dupin::drawing {

/// The axis of a part.
struct PartAxis {
  std::string part;
  std::vector<Vec3> line;         ///< the centres of its circles; of a ball its centre alone
  std::vector<double> diameters;  ///< of its ends, or of the ball
};

/// Of every part, in the order of the assembly. Segments are within `tolerance` of curved axes at
/// their middles, as far as 256 of them for a piece get.
[[nodiscard]] std::vector<PartAxis> axes_of(const ResolvedAssembly& assembly, double tolerance);

}  // namespace dupin::drawing
