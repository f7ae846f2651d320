#pragma once

#include <optional>
#include <vector>

#include "dupin/blends/regularity.h"
#include "dupin/blends/ringed_surface.h"
#include "dupin/kernel/ring.h"

namespace dupin {

/// The radius laws of [MS06]: R1 is CubicRadius, R2 is CyclideRadius.
enum class BlendLaw { r1, r2 };

/// What the blend shares with its neighbours at the ends: tangent planes, or curvatures too.
enum class Continuity { g1, g2 };

struct CyclicBlendOptions {
  BlendLaw radius_law = BlendLaw::r1;
  std::optional<double> k = {};  ///< length of the spine's start velocity; none: chosen
  std::optional<double> l = {};  ///< length of the spine's end velocity; none: chosen
  double margin = 0.05;          ///< least acceptable min(1 - kappa R), in [0, 1)
  Continuity continuity = Continuity::g1;
};

/// End speeds of a blend's spine and what they lead to.
struct BlendChoice {
  double k = 0, l = 0;
  double bending_energy = 0;  ///< integral of kappa^2 ds
  double margin = 0;          ///< certified lower bound of min(1 - kappa R)
  double length = 0;          ///< of the spine
};

/// A ringed surface that goes on smoothly from cylinders or cones (rings with a slope) at both ends
/// [MS06]. The spine has the least degree that does it: cubic for G1 between cylinders, quintic for
/// G1 with a cone and for G2 between cylinders, septic for G2 with a cone (a cone also demands that
/// the spine's end has no curvature). All but the cubic take a Bezier radius of the same degree,
/// which is R1's role; R2 is for the cubic only.
///
/// The rings are ports of the neighbours: normals point out of them, so that the blend leaves along
/// from.normal and arrives against to.normal. The surface stores flipped(from) and flipped(to),
/// bitwise. Speeds that are not given are chosen by choose_velocities.
///
/// Throws Error{irregular_surface} where given speeds make the surface fold or the radius vanish
/// (parameter interval, missing margin, and speeds that would work), Error{infeasible_blend} where
/// none of the speeds that are searched work (with the largest margin of these, and with speeds of
/// up to 64 times the distance of the centres that work, if any are found),
/// Error{invalid_argument} for bad numbers, rings of equal centre, and R2 where it does not apply.
[[nodiscard]] RingedSurface cyclic_blend(const Ring& from, const Ring& to,
                                         const CyclicBlendOptions& options = {});

/// Of the end speeds between 0.05 and 5 times the distance of the centres, with a spine of at most
/// 3 times that distance and the asked margin, certified, those of least bending energy. Given
/// speeds are kept. Throws as cyclic_blend. A few milliseconds.
[[nodiscard]] BlendChoice choose_velocities(const Ring& from, const Ring& to,
                                            const CyclicBlendOptions& options = {});

/// Of the same speeds, those of the largest margin (options.margin has no influence).
[[nodiscard]] BlendChoice widest_velocities(const Ring& from, const Ring& to,
                                            const CyclicBlendOptions& options = {});

/// What is wrong with given speeds, and what would be right.
struct BlendAdvice {
  std::vector<ParameterInterval> violations;  ///< where the margin is missed, proven outside
  double missing_margin = 0;                  ///< options.margin less the surface's
  /// The most by which the radius exceeds the radius of curvature that the margin leaves it, (1 -
  /// margin) / kappa.
  double missing_length = 0;
  /// Of the speeds that choose_velocities searches:
  std::optional<BlendChoice> nearest;  ///< those that work, nearest in the logarithms
  std::optional<BlendChoice> widest;   ///< those of the largest margin
};

/// Both speeds must be given. Throws as cyclic_blend for bad numbers.
[[nodiscard]] BlendAdvice blend_advice(const Ring& from, const Ring& to,
                                       const CyclicBlendOptions& options);

/// The integral of kappa^2 ds along a spine that does not stop.
[[nodiscard]] double bending_energy(const Spine& spine);

}  // namespace dupin
