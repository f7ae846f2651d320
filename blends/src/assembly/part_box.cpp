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

Eigen::AlignedBox3d box_of(const Piece& piece) {
  const surfaces::PieceDiscs discs =
      std::visit([](const auto& one) { return surfaces::discs(one); }, piece);
  const surfaces::DiscHull hull = discs.hull({0, 1});
  Eigen::AlignedBox3d box;
  for (int k = 0; k < 3; ++k) {
    box.max()[k] = surfaces::support(hull, Vec3::Unit(k));
    box.min()[k] = -surfaces::support(hull, -Vec3::Unit(k));
  }
  return box.min().array().isNaN().any() || box.max().array().isNaN().any() ? everywhere() : box;
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
