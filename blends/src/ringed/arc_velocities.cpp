#include "ringed/arc_velocities.h"

#include <cmath>

#include "numbers/angle.h"
#include "ringed/blend_shape.h"

namespace dupin::ringed {

std::optional<CyclicBlendOptions> arc_velocities(const Ring& from, const Ring& to, double margin) {
  const double distance = (to.center - from.center).norm();
  const double quarter = numbers::angle_between(from.normal, Vec3::Zero() - to.normal) / 4;
  const double speed = distance / (std::cos(quarter) * std::cos(quarter));
  const CyclicBlendOptions options{.k = speed, .l = speed, .margin = margin};
  const HermiteSpine hermite{from.center, to.center, speed * from.normal, -speed * to.normal};
  const bool is_cylindric = from.slope == 0 && to.slope == 0;
  const Spine spine = is_cylindric ? Spine(hermite) : Spine(quintic_spine(hermite));
  const RingedSurface blend{
      flipped(from), flipped(to), spine,
      blend_radius({from.radius, from.slope, to.radius, to.slope}, spine, options)};
  const bool is_regular =
      smallest_radius(blend.radius) > 0 && prove_margin(blend, margin).verdict == Verdict::proved;
  return is_regular ? std::optional(CyclicBlendOptions{.k = speed, .l = speed}) : std::nullopt;
}

}  // namespace dupin::ringed
