#include "assembly/part_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>

#include "numbers/interval.h"
#include "surfaces/pieces/surface_piece.h"

namespace dupin::assembly {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vec3 axis(const View& axes, int k) { return k == 0 ? axes.right : k == 1 ? axes.up : axes.towards; }

bool is_along_coordinates(const View& axes) {
  return std::ranges::all_of(std::array{0, 1, 2}, [&](int k) {
    return axis(axes, k).cwiseAbs().maxCoeff() == axis(axes, k).lpNorm<1>();
  });
}

Eigen::AlignedBox3d everywhere() { return {Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity)}; }

// Some hulls know nothing of long stretches.
constexpr int kMostHalvings = 6;

Eigen::AlignedBox3d box_of(const surfaces::PieceDiscs& discs, const ParameterInterval& stretch,
                           const View& axes, int halvings) {
  const surfaces::DiscHull hull = discs.hull(stretch);
  Eigen::AlignedBox3d box;
  for (int k = 0; k < 3; ++k) {
    box.max()[k] = surfaces::support(hull, axis(axes, k));
    box.min()[k] = -surfaces::support(hull, -axis(axes, k));
  }
  if (box.min().allFinite() && box.max().allFinite()) {
    return box;
  }
  if (halvings == kMostHalvings) {
    return everywhere();
  }
  const auto [first, second] = surfaces::halves(stretch);
  return box_of(discs, first, axes, halvings + 1).merged(box_of(discs, second, axes, halvings + 1));
}

// Of a sphere times a weight, in R^{3,1}.
struct WeightedSphere {
  numbers::IntervalVec center;
  numbers::Interval radius, weight;
};

WeightedSphere half_way(const WeightedSphere& a, const WeightedSphere& b) {
  const numbers::Interval half = 0.5;
  return {half * (a.center + b.center), half * (a.radius + b.radius), half * (a.weight + b.weight)};
}

// Of the spheres that the piece envelops, which hold it: as far as its control spheres in all
// directions, where their weights are positive, as they are on either half of any arc.
Eigen::AlignedBox3d box_of_spheres(const CyclidePiece& piece, const View& axes) {
  const numbers::IntervalVec first = numbers::interval_vec(piece.first.m),
                             last = numbers::interval_vec(piece.last.m),
                             tangent = numbers::interval_vec(piece.tangent.m);
  const numbers::IntervalVec d = last - first;
  const numbers::Interval dr = numbers::Interval(piece.last.r) - piece.first.r, chord = piece.chord;
  const numbers::Interval squared = numbers::dot(d, d) - square(dr);
  const numbers::Interval w = (numbers::dot(d, tangent) - dr * piece.tangent.r) / chord;
  const numbers::Interval half = squared / (numbers::Interval(2) * chord);
  const numbers::Interval weight = squared / square(chord);  // but for rounding 1
  const WeightedSphere a{first, piece.first.r, 1},
      b{w * first + half * tangent, w * piece.first.r + half * piece.tangent.r, w},
      c{weight * last, weight * piece.last.r, weight};
  const WeightedSphere ab = half_way(a, b), bc = half_way(b, c);
  Eigen::AlignedBox3d box;
  for (const WeightedSphere& sphere : {a, ab, half_way(ab, bc), bc, c}) {
    if (!(sphere.weight.lower > 0)) {
      return everywhere();
    }
    for (int k = 0; k < 3; ++k) {
      const numbers::Interval center =
          numbers::dot(sphere.center, numbers::interval_vec(axis(axes, k)));
      box.min()[k] = std::min(box.min()[k], ((center - sphere.radius) / sphere.weight).lower);
      box.max()[k] = std::max(box.max()[k], ((center + sphere.radius) / sphere.weight).upper);
    }
  }
  return box;
}

Eigen::AlignedBox3d box_of(const Piece& piece, const View& axes) {
  const Eigen::AlignedBox3d box = box_of(
      std::visit([](const auto& one) { return surfaces::discs(one); }, piece), {0, 1}, axes, 0);
  const auto* cyclide = std::get_if<CyclidePiece>(&piece);
  return cyclide == nullptr ? box : box.intersection(box_of_spheres(*cyclide, axes));
}

Eigen::AlignedBox3d box_of(const Sphere& sphere, const View& axes) {
  Eigen::AlignedBox3d box;
  for (int k = 0; k < 3; ++k) {
    const numbers::Interval center =
        numbers::dot(numbers::interval_vec(sphere.center), numbers::interval_vec(axis(axes, k)));
    box.min()[k] = (center - numbers::Interval(sphere.radius)).lower;
    box.max()[k] = (center + numbers::Interval(sphere.radius)).upper;
  }
  return box;
}

Eigen::AlignedBox3d box_of(const Chain& chain, const View& axes) {
  if (chain.pieces.empty()) {
    return everywhere();
  }
  Eigen::AlignedBox3d box;
  for (const Piece& piece : chain.pieces) {
    box.extend(box_of(piece, axes));
  }
  return box;
}

}  // namespace

Eigen::AlignedBox3d part_box(const PartSurface& surface, const View& axes) {
  return std::visit([&](const auto& shape) { return box_of(shape, axes); }, surface);
}

std::optional<View> main_axes(std::span<const PartSurface* const> parts) {
  constexpr double kMuchLess = 0.75;
  std::vector<Vec3> chords;
  for (const PartSurface* part : parts) {
    if (const auto* chain = std::get_if<Chain>(part)) {
      for (const Piece& piece : chain->pieces) {
        chords.push_back(end_ring(piece, End::end).center - end_ring(piece, End::start).center);
      }
    }
  }
  const auto axes = view_of_most(chords);
  if (axes && is_along_coordinates(*axes)) {
    return std::nullopt;
  }
  const auto surface = [&](const View& along) {
    double sum = 0;
    for (const PartSurface* part : parts) {
      const Vec3 size = part_box(*part, along).sizes();
      sum += size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
    }
    return sum;
  };
  return axes && surface(*axes) < kMuchLess * surface({}) ? axes : std::nullopt;
}

}  // namespace dupin::assembly
