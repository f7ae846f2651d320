#pragma once

#include <array>
#include <vector>

#include "dupin/blends/pe_arc.h"

namespace dupin {

/// A rational biquadratic Bezier patch: 3 x 3 homogeneous control points (w x, w y, w z, w), rows
/// along the spine.
struct BiquadraticPatch {
  std::array<std::array<Vec3, 3>, 3> points;       ///< w times the point
  std::array<std::array<double, 3>, 3> weights{};  ///< positive
};

[[nodiscard]] Vec3 evaluate(const BiquadraticPatch& patch, double t, double s);

/// The exact piece as patches with positive weights and boundary arcs of at most 90 degrees, row by
/// row (along the spine), four or more columns around.
[[nodiscard]] std::vector<BiquadraticPatch> patches(const PeArc& arc);

}  // namespace dupin
