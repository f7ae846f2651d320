#include "dupin/blends/cyclide_tube.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "cyclide/arc_bounds.h"
#include "cyclide/require_pieces.h"
#include "dupin/blends/cyclide_form.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using cyclide::ArcConstants;
using numbers::Interval;

// kappa R = r (kappa + |A x k|) / (1 + tau^2), a number per place.
Interval bend(const ArcConstants& arc, double from, double to) {
  const auto [r, tau, kappa] = cyclide::stretch(arc, from, to);
  return r * (kappa + arc.turning) / (Interval(1) + square(tau));
}

// The derivative of kappa R by the tangential length is tau (kappa + |A x k|) (1 - kappa R) /
// (1 + tau^2), where kappa + |A x k| never changes its sign: (A x k)^2 - kappa^2 = kk (1 + tau^2)
// vanishes nowhere, or everywhere. So kappa R is largest at an end or where tau = 0.
Interval largest_bend(const ArcConstants& arc, double from, double to) {
  const Interval ends = max(bend(arc, from, from), bend(arc, to, to));
  const Interval tau = cyclide::stretch(arc, from, to).tau;
  if (tau.lower >= 0 || tau.upper <= 0) {
    return ends;
  }
  const double middle = (from + to) / 2;
  // Twenty halvings leave the error of a flat extremum below a unit of 2^-40.
  const double upper = bend(arc, from, to).upper;
  if (to - from < std::ldexp(1.0, -20) || upper <= ends.upper + std::ldexp(1.0, -40)) {
    return {ends.lower, std::max(ends.upper, upper)};
  }
  return max(largest_bend(arc, from, middle), largest_bend(arc, middle, to));
}

// Between the planes of the outer and the inner disc at an end, signed: positive where the inner
// disc lies further out.
double rim_volume(const Ring& outer, const Ring& inner) {
  const double height = (inner.center - outer.center).dot(outer.normal);
  const double a = outer.radius, b = inner.radius;
  return std::numbers::pi / 3 * height * (a * a + a * b + b * b);
}

// The circle at distance `wall` inwards along the normals of the cone of the ring's slope.
Ring inside(const Ring& ring, double wall) {
  const double stretch = std::hypot(1, ring.slope);
  return {ring.center + wall * ring.slope / stretch * ring.normal, ring.normal,
          ring.radius - wall / stretch, ring.slope};
}

}  // namespace

Chain cyclide_tube(const CyclideChain& chain, const Ring& start, const Ring& end) {
  cyclide::require_pieces(chain);
  std::vector<CyclidePiece> pieces;
  for (const PeArc& arc : chain.pieces) {
    pieces.push_back(cyclide_piece(arc));
  }
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    pieces[i].end = flipped(pieces[i + 1].start);
  }
  pieces.front().start = start;
  pieces.back().end = end;
  return Chain(pieces);
}

Chain cyclide_tube(const CyclideChain& chain, double wall) {
  cyclide::require_pieces(chain);
  return hollow(cyclide_tube(chain, flipped(circle_at(chain.pieces.front(), 0)),
                             circle_at(chain.pieces.back(), 1)),
                wall);
}

Chain hollow(Chain chain, double wall) {
  cyclide::require_pieces(chain);
  if (!(wall >= 0)) {
    throw Error(Errc::invalid_argument, "the wall's thickness must not be negative");
  }
  const std::vector<PeArc> arcs = cyclide_pieces(chain);
  for (std::size_t i = 0; wall > 0 && i < arcs.size(); ++i) {
    const double least = least_radius(arcs[i]);
    if (!(least > wall)) {
      throw PieceError(
          i, Error(Errc::infeasible_blend, "the wall of " + decimal(wall, kMessageDigits) +
                                               " is no thinner than the least sphere, of radius " +
                                               decimal(least, kMessageDigits)));
    }
  }
  chain.wall = wall;
  if (wall > 0) {
    (void)inner_skin(chain);
  }
  return chain;
}

Chain inner_skin(const Chain& chain) {
  cyclide::require_pieces(chain);
  const CyclideChain outer{cyclide_pieces(chain)};
  if (outer.pieces.size() != chain.pieces.size()) {
    throw Error(Errc::invalid_argument, "only chains of cyclides can have a wall");
  }
  const Ring start = inside(end_ring(chain, End::start), chain.wall),
             end = inside(end_ring(chain, End::end), chain.wall);
  if (chain.joints == Joints::smooth) {
    return cyclide_tube(offset(outer, -chain.wall), start, end);
  }
  Chain result;
  for (const PeArc& arc : outer.pieces) {
    result.pieces.emplace_back(
        cyclide_piece(offset(CyclideChain{{arc}}, -chain.wall).pieces.front()));
  }
  std::get<CyclidePiece>(result.pieces.front()).start = start;
  std::get<CyclidePiece>(result.pieces.back()).end = end;
  result.joints = chain.joints;
  return result;
}

Enclosure margin(const PeArc& arc) {
  const ArcConstants constants(arc);
  // Cells in which the weights stay positive.
  constexpr int kCells = 32;
  Interval largest;
  for (int i = 0; i < kCells; ++i) {
    const Interval here =
        largest_bend(constants, cyclide::parameter_at(arc, static_cast<double>(i) / kCells),
                     cyclide::parameter_at(arc, (i + 1.0) / kCells));
    largest = i == 0 ? here : max(largest, here);
  }
  const Interval result = Interval(1) - largest;
  return {result.lower, result.upper};
}

// The walls differ by at most the angle between the axes and that between the half angles, which is
// at most the difference of their tangents. For a sine x <= 1/2 the angle is at most x (1 + x^2).
double tangency_bound(const CyclidePiece& piece, End end) {
  const bool at_start = end == End::start;
  const Ring ring = at_start ? flipped(piece.start) : piece.end;
  const PeVector tangent = at_start ? piece.tangent : arc_of(piece).end_tangent();
  if (tangent == PeVector{ring.normal, ring.slope}) {
    return 0;
  }
  const auto axis = numbers::interval_vec(tangent.m), normal = numbers::interval_vec(ring.normal);
  const Interval sine =
      numbers::norm(numbers::cross(axis, normal)) / (numbers::norm(axis) * numbers::norm(normal));
  if (sine.upper > 0.5) {
    return std::numbers::pi;
  }
  const Interval angle = sine * (Interval(1) + square(sine));
  return (angle + Interval((Interval(tangent.r) - ring.slope).magnitude())).upper;
}

double area(const Chain& chain) {
  cyclide::require_pieces(chain);
  double sum = chain.wall > 0 ? area(inner_skin(chain)) : 0;
  for (const PeArc& piece : cyclide_pieces(chain)) {
    sum += area(piece);
  }
  return sum;
}

double volume(const Chain& chain) {
  cyclide::require_pieces(chain);
  double sum = 0;
  for (const PeArc& piece : cyclide_pieces(chain)) {
    sum += volume(piece);
  }
  if (chain.wall > 0) {
    const Chain inner = inner_skin(chain);
    for (const End end : {End::start, End::end}) {
      sum += rim_volume(end_ring(chain, end), end_ring(inner, end));
    }
    sum -= volume(inner);
  }
  return sum;
}

std::string_view kind(const Chain& chain) {
  cyclide::require_pieces(chain);
  constexpr std::array<std::string_view, 3> kNames{"single", "double", "triple"};
  const std::size_t pieces = chain.pieces.size();
  return pieces <= kNames.size() ? kNames.at(pieces - 1) : "chain";
}

}  // namespace dupin
