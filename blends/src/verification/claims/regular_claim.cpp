#include "verification/claims/regular_claim.h"

#include <algorithm>

#include "verification/admitted.h"
#include "verification/work.h"

namespace dupin::verification {
namespace {

// The curvature as |y' x y''|^2 w^4 / |y'|^6, in the stretch's own parameter: it makes no
// difference. Of arcs, a bound of it.
struct Curvature {
  Polynomial above, below;
};
enum class Bound { upper, lower };

Polynomial square(const Polynomial& p) { return product(p, p); }

Curvature curvature(const Tube& tube, double from, double to, Bound bound) {
  if (const ArcSpine* arc = tube.arc()) {
    // The affine image of a circle: |y'|^2 lies between the eigenvalues of its Gram matrix.
    Curve u, v;
    for (int k = 0; k < 3; ++k) {
      u[k] = {mpq_class(arc->start[k]) - mpq_class(arc->center[k])};
    }
    const Vec3& axis = arc->axis;
    v = cross(Curve{Polynomial{axis.x()}, Polynomial{axis.y()}, Polynomial{axis.z()}}, u);
    const mpq_class uu = dot(u, u)[0], vv = dot(v, v)[0], uv = dot(u, v)[0];
    const mpq_class speed = bound == Bound::upper ? mpq_class(std::min(uu, vv) - abs(uv))
                                                  : mpq_class(std::max(uu, vv) + abs(uv));
    const Curve bend = cross(u, v);
    return {dot(bend, bend), {speed * speed * speed}};
  }
  const Stretch s = tube.stretch(from, to);
  const Curve bend = cross(s.tangent, derivative(s.tangent));
  const Polynomial speed = dot(s.tangent, s.tangent);
  return {product(dot(bend, bend), square(square(s.weight))), product(speed, square(speed))};
}

// (1 - margin)^2 |y'|^6 - R^2 |y' x y''|^2 w^4
Polynomial excess(const Tube& tube, double margin, double from, double to, const Polynomial& radius,
                  Bound bound = Bound::upper) {
  const Curvature c = curvature(tube, from, to, bound);
  const mpq_class room = 1 - mpq_class(margin);
  return difference(product({room * room}, c.below), product(square(radius), c.above));
}

bool all_positive(const Polynomial& p) {
  return std::all_of(p.begin(), p.end(), [](const mpq_class& x) { return x > 0; });
}

// A CyclideRadius is replaced by its largest value, on smaller stretches where that is too much.
bool is_regular_on(const Tube& tube, double margin, double from, double to, int halvings) {
  const Polynomial radius = tube.radius(from, to);
  if (!radius.empty()) {
    return all_positive(radius) && all_positive(excess(tube, margin, from, to, radius));
  }
  const Interval range = tube.radius_range(from, to);
  if (range.lower > 0 && all_positive(excess(tube, margin, from, to, {range.upper}))) {
    return true;
  }
  const double middle = (from + to) / 2;
  return halvings > 0 && is_regular_on(tube, margin, from, middle, halvings - 1) &&
         is_regular_on(tube, margin, middle, to, halvings - 1);
}

// By intervals: (1 - margin) c'.n > R |n'|.
bool is_regular_on(const Motion& motion, double margin, double from, double to, int halvings) {
  const auto disc = motion(from, to);
  if (disc) {
    const Interval advance = numbers::dot(part(disc->center, 1), part(disc->normal, 0));
    const Interval turning = numbers::norm(part(disc->normal, 1));
    if (disc->radius[0].lower > 0 &&
        ((Interval(1) - margin) * advance - disc->radius[0] * turning).lower > 0) {
      return true;
    }
  }
  const double middle = (from + to) / 2;
  return halvings > 0 && is_regular_on(motion, margin, from, middle, halvings - 1) &&
         is_regular_on(motion, margin, middle, to, halvings - 1);
}

bool is_regular_on(const Piece& piece, double margin, const ParameterInterval& t) {
  constexpr int kHalvings = 24, kMotionHalvings = 6;
  if (piece.tubes.empty()) {
    return is_regular_on(piece.steered, margin, t.from, t.to, kMotionHalvings) &&
           (!piece.inner || is_regular_on(piece.inner, margin, t.from, t.to, kMotionHalvings));
  }
  return std::all_of(piece.tubes.begin(), piece.tubes.end(), [&](const Tube& tube) {
    return is_regular_on(tube, margin, t.from, t.to, kHalvings);
  });
}

// At an end of a stretch: on one without length nothing moves, and all is zero.
bool fails_at(const Tube& tube, double margin, double t) {
  const double from = t < 1 ? t : 0, least = tube.radius_range(t, t).lower;
  const Polynomial radius = tube.radius(from, 1);
  const Polynomial found =
      excess(tube, margin, from, 1, radius.empty() ? Polynomial{least} : radius, Bound::lower);
  return least > 0 && (t < 1 ? found.front() : found.back()) <= 0;
}

// An ellipse may keep clear where the circle about it does not.
bool is_refuted(const Solid& solid, const RegularClaim& claim) {
  const Piece* piece = solid.piece(claim.where);
  if (piece == nullptr || piece->tubes.size() != 1) {
    return false;
  }
  const ParameterInterval where = within_piece(claim.where);
  return fails_at(piece->tubes.front(), claim.margin, where.from) ||
         fails_at(piece->tubes.front(), claim.margin, where.to);
}

}  // namespace

bool has_form(const Solid& solid, const RegularClaim& claim) {
  return claim.margin >= 0 && claim.margin < 1 &&
         (claim.verdict == Verdict::proved || claim.leaves.empty()) &&
         (claim.where == ParameterInterval{} ||
          (claim.verdict != Verdict::proved && is_stretch(claim.where, solid.length())));
}

bool follows(const Solid& solid, const RegularClaim& claim) {
  if (!has_form(solid, claim) || claim.verdict == Verdict::undecided) {
    return false;
  }
  if (claim.verdict == Verdict::refuted) {
    return is_refuted(solid, claim);
  }
  const auto& leaves = claim.leaves;
  const auto follows_on = [&](std::size_t i) {
    const ParameterInterval& leaf = leaves[i];
    const Piece* piece = solid.piece(leaf);
    return leaf.from == (i == 0 ? 0 : leaves[i - 1].to) && leaf.from < leaf.to &&
           is_stretch(leaf, solid.length()) && piece != nullptr &&
           is_regular_on(*piece, claim.margin, within_piece(leaf));
  };
  return holds_of_all(leaves.size(), follows_on) &&
         (leaves.empty() ? 0 : leaves.back().to) == solid.length();
}

}  // namespace dupin::verification
