#include "assembly/part_box.h"

#include <cmath>
#include <limits>
#include <variant>

#include "numbers/interval.h"
#include "surfaces/surface_piece.h"

namespace dupin::assembly {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Eigen::AlignedBox3d everywhere() { return {Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity)}; }

// Some hulls know nothing of long stretches.
constexpr int kMostHalvings = 6;

Eigen::AlignedBox3d box_of(const surfaces::PieceDiscs& discs, const ParameterInterval& stretch,
                           int halvings) {
  const surfaces::DiscHull hull = discs.hull(stretch);
  Eigen::AlignedBox3d box;
  for (int k = 0; k < 3; ++k) {
    box.max()[k] = surfaces::support(hull, Vec3::Unit(k));
    box.min()[k] = -surfaces::support(hull, -Vec3::Unit(k));
  }
  if (box.min().allFinite() && box.max().allFinite()) {
    return box;
  }
  if (halvings == kMostHalvings) {
    return everywhere();
  }
  const auto [first, second] = surfaces::halves(stretch);
  return box_of(discs, first, halvings + 1).merged(box_of(discs, second, halvings + 1));
}

Eigen::AlignedBox3d box_of(const Piece& piece) {
  return box_of(std::visit([](const auto& one) { return surfaces::discs(one); }, piece), {0, 1}, 0);
}

Eigen::AlignedBox3d box_of(const Sphere& sphere) {
  Eigen::AlignedBox3d box;
  for (int k = 0; k < 3; ++k) {
    const numbers::Interval center = sphere.center[k];
    box.min()[k] = (center - numbers::Interval(sphere.radius)).lower;
    box.max()[k] = (center + numbers::Interval(sphere.radius)).upper;
  }
  return box;
}

Eigen::AlignedBox3d box_of(const Chain& chain) {
  if (chain.pieces.empty()) {
    return everywhere();
  }
  Eigen::AlignedBox3d box;
  for (const Piece& piece : chain.pieces) {
    box.extend(box_of(piece));
  }
  return box;
}

}  // namespace

Eigen::AlignedBox3d part_box(const PartSurface& surface) {
  return std::visit([](const auto& shape) { return box_of(shape); }, surface);
}

}  // namespace dupin::assembly
