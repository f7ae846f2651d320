#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

#include "dupin/blends/certificate.h"
#include "verification/motions/jet.h"
#include "verification/motions/tube.h"

namespace dupin::verification {

/// What a look at one costs: products and roots of jets.
constexpr std::uint64_t kDiscWork = 16;

/// A disc and how it moves, over a stretch of a piece's parameter: centre, unit normal and radius
/// with two derivatives; and the rate of the length that `mesh` measures bands by.
struct MovingDisc {
  JetVec<3> center, normal;
  Jet<3> radius, pace;
  /// The rotation of the frame that the rows of `mesh` follow, and its derivative; none where they
  /// follow one that does not spin about the normal.
  std::optional<std::array<IntervalVec, 2>> spin = {};
};

/// Encloses the discs over the stretch [from, to] within [0, 1]; none where the numbers do not tell
/// that they move at all.
using Motion = std::function<std::optional<MovingDisc>(double from, double to)>;

/// The spheres of a piece of a cyclide over a stretch, with three derivatives: centres less that of
/// the first, radii, and the weight that both are polynomials over.
struct MovingSphere {
  JetVec<4> center;
  Jet<4> radius, weight;
};

/// None where the numbers do not tell that there are spheres at all.
using SphereMotion = std::function<std::optional<MovingSphere>(double from, double to)>;

/// Of the outer skin, or of the parallel one at distance `wall` inside.
[[nodiscard]] SphereMotion sphere_motion(const CyclidePiece& piece, double wall);

/// What spheres (m; r) of the outer skin are less the last one, divided by 1 - t.
[[nodiscard]] SphereMotion approach(const CyclidePiece& piece);

[[nodiscard]] Motion motion(const Tube& tube);
/// Of the discs about an elliptic tube's sections. Their radius holds bounds: no point of the
/// sections x(t, u) - c(t) is further out, nor has it, in a frame that does not spin about the
/// normal, larger derivatives by t. Empty where the numbers do not tell how the axes turn.
/// `first` is the motion of the tube that has the first semi-axis for a radius.
[[nodiscard]] Motion motion(const EllipticTube& tube, const Motion& first, const Tube& second);
/// Of the outer skin, or of the parallel one at distance `wall` inside.
[[nodiscard]] Motion motion(const CyclidePiece& piece, double wall);
[[nodiscard]] Motion motion(const RationalRingedSurface& surface);
/// With all first derivatives divided by the same positive function, so that they do not vanish
/// where centre and normal come to rest at an end; the second ones have no meaning.
[[nodiscard]] Motion steered_motion(const RationalRingedSurface& surface);

template <std::size_t count>
[[nodiscard]] JetVec<count> moved(JetVec<count> v, const IntervalVec& by) {
  for (std::size_t k = 0; k < 3; ++k) {
    v[k][0] = v[k][0] + by[k];
  }
  return v;
}

}  // namespace dupin::verification
