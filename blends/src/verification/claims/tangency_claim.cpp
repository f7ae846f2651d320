#include "verification/claims/tangency_claim.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dupin::verification {
namespace {

// With q = v - R e.T', x_t = q T + R' e, and the normal curvature along x_t is
//   (q (q e.T' + R'') - R' (v' - 2 R' e.T' - R e.T'')) / (q^2 + R'^2)^(3/2).
bool curvature_follows(const Piece& piece, double claimed, End end) {
  const double t = end == End::end ? 1 : 0;
  const auto disc = piece.tubes.size() == 1 ? piece.motion(t, t) : std::nullopt;
  if (!disc) {
    return false;
  }
  const IntervalVec n = part(disc->normal, 0), velocity = part(disc->center, 1);
  const Interval either(-1, 1), bend = either * numbers::norm(part(disc->normal, 1)).upper;
  const Interval across = either * numbers::norm(numbers::cross(part(disc->normal, 2), n)).upper;
  const Jet<3>& r = disc->radius;
  const Interval q = numbers::norm(velocity) - r[0] * bend;
  const Interval along =
      numbers::dot(part(disc->center, 2), n) - Interval(2) * r[1] * bend - r[0] * across;
  const Interval squared = square(q) + square(r[1]);
  return q.lower > 0 &&
         ((q * (q * bend + r[2]) - r[1] * along) / (squared * numbers::sqrt(squared)))
                 .magnitude() <= claimed;
}

}  // namespace

// Of pieces of unknown size only the second lemma speaks, which counts how much discs turn at
// joints. A disc that is further off than its ring is wide has no joint there, whatever tolerance a
// certificate states.
bool is_near(const TangencyClaim& claim, const Ring& ring, double size_of_piece, double tolerance) {
  const double size =
      std::isfinite(size_of_piece) ? std::max(size_of_piece, ring.radius) : ring.radius;
  const double width = ring.ellipse ? std::min(ring.radius, ring.ellipse->across) : ring.radius;
  return (Interval(claim.offset) + Interval(claim.axis_angle) * size).upper <=
         std::min(tolerance, width);
}

bool follows(const Piece& piece, const TangencyClaim& claim, End end) {
  const bool has_none = piece.tubes.size() == 1 && piece.tubes.front().is_cone();
  if (claim.curvature &&
      !(has_none ? *claim.curvature >= 0 : curvature_follows(piece, *claim.curvature, end))) {
    return false;
  }
  spend(200);
  const EndDifference found = end_difference(piece, end);
  return found.axis_angle.rounded_outward().upper <= claim.axis_angle &&
         found.offset.rounded_outward().upper <= claim.offset &&
         claim.deviation.has_value() == found.deviation.has_value() &&
         (!claim.deviation || *found.deviation <= *claim.deviation);
}

}  // namespace dupin::verification
