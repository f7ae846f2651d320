#include "certification/end_tangency.h"

#include <algorithm>

#include "certification/swept_discs.h"
#include "dupin/blends/curvature_jump.h"
#include "dupin/kernel/error.h"
#include "numbers/mpfi_interval.h"

namespace dupin::certification {
namespace {

using Mpfi = numbers::MpfiInterval<128>;

double largest_angle(const numbers::Interval& y, const numbers::Interval& x) {
  return angle(Mpfi::between(y.lower, y.upper), Mpfi::between(x.lower, x.upper))
      .rounded_outward()
      .upper;
}

struct EndRing {
  const Ring& ring;
  bool at_end;

  [[nodiscard]] numbers::IntervalVec travel() const {
    return numbers::interval_vec(at_end ? ring.normal : Vec3(-ring.normal));
  }
  [[nodiscard]] double slope() const { return at_end ? ring.slope : -ring.slope; }
};

// Where a spine ends in a stored point, that one.
numbers::IntervalVec center_at(const CertifiedPiece& piece, const DiscHull& disc, bool at_end) {
  struct Stored {
    bool at_end;
    std::optional<Vec3> operator()(const LineSpine& s) const { return at_end ? s.to : s.from; }
    std::optional<Vec3> operator()(const HermiteSpine& s) const { return at_end ? s.to : s.from; }
    std::optional<Vec3> operator()(const BezierSpine& s) const {
      return at_end ? s.points.back() : s.points.front();
    }
    std::optional<Vec3> operator()(const ArcSpine&) const { return std::nullopt; }
  };
  const auto* tube = std::get_if<RingedSurface>(&piece);
  const auto* elliptic = std::get_if<EllipticTube>(&piece);
  const Spine* spine = tube != nullptr       ? &tube->spine
                       : elliptic != nullptr ? &elliptic->spine
                                             : nullptr;
  const auto stored = spine != nullptr ? std::visit(Stored{at_end}, *spine) : std::nullopt;
  return stored ? numbers::interval_vec(*stored) : disc.centers.front();
}

// Of the centres and of the radii, a ringed surface's or those of an ellipse's two semi-axes.
double offset(const CertifiedPiece& piece, const EndRing& end) {
  const double t = end.at_end ? 1 : 0;
  const DiscHull disc = hull_over(piece_discs(piece), {t, t});
  const numbers::Interval apart =
      numbers::norm(center_at(piece, disc, end.at_end) - numbers::interval_vec(end.ring.center));
  if (const auto* tube = std::get_if<EllipticTube>(&piece)) {
    const numbers::Interval first = evaluate(tube->first, t).value,
                            second = evaluate(tube->second, t).value;
    return (apart + (first - end.ring.radius).magnitude() + (second - across(end.ring)).magnitude())
        .upper;
  }
  const auto* tube = std::get_if<RingedSurface>(&piece);
  const numbers::Interval radius = tube != nullptr ? evaluate(tube->radius, t).value : disc.radius;
  return (apart + (radius - end.ring.radius).magnitude()).upper;
}

TangencyClaim differences(const RingedSurface& tube, const EndRing& end) {
  const Tangency found = tangency_at_end(tube, end.at_end ? End::end : End::start);
  // Adding 0 takes the sign from a zero.
  return {found.deviation.upper + 0.0, found.axis_angle.upper + 0.0, 0, {}};
}

// None where the surface folds. With room for a checker's own rounding.
std::optional<double> curvature(const RingedSurface& tube, bool at_end) {
  try {
    const double bound = curvature_jump_bound(tube, at_end ? End::end : End::start);
    const double radius = evaluate(tube.radius, at_end ? 1 : 0).value;
    const bool is_straight = std::holds_alternative<LineSpine>(tube.spine) &&
                             (std::holds_alternative<ConstantRadius>(tube.radius) ||
                              std::holds_alternative<LinearRadius>(tube.radius));
    return is_straight ? 0 : bound * (1 + 0x1p-20) + 0x1p-40 / radius;
  } catch (const Error&) {
    return std::nullopt;
  }
}

TangencyClaim differences(const EllipticTube& tube, const EndRing& end) {
  const TangencyClaim about =
      differences(RingedSurface{tube.start, tube.end, tube.spine, tube.first}, end);
  const double deviation = tangency_bound(tube, end.at_end ? End::end : End::start);
  return {deviation * (1 + 0x1p-20), about.axis_angle, 0, {}};  // room for a checker's own rounding
}

// With the PE-tangent (A; tau) at the end, (2 e / D) d - tangent.
TangencyClaim differences(const CyclidePiece& piece, const EndRing& end) {
  numbers::IntervalVec along = numbers::interval_vec(piece.tangent.m);
  numbers::Interval rise = piece.tangent.r;
  if (end.at_end) {
    const numbers::IntervalVec d =
        numbers::interval_vec(piece.last.m) - numbers::interval_vec(piece.first.m);
    const numbers::Interval dr = numbers::Interval(piece.last.r) - piece.first.r;
    const numbers::Interval factor = numbers::Interval(2) * (numbers::dot(d, along) - dr * rise) /
                                     (numbers::dot(d, d) - square(dr));
    along = factor * d - along;
    rise = factor * dr - rise;
  }
  const numbers::Interval advance = numbers::sqrt(numbers::dot(along, along) - square(rise)),
                          slope = end.slope();
  const numbers::Interval off = (rise - advance * slope).magnitude();
  return {largest_angle(off, advance + rise * slope),
          largest_angle(numbers::norm(numbers::cross(along, end.travel())),
                        numbers::dot(along, end.travel())),
          0,
          {}};
}

TangencyClaim differences(const RationalRingedTube& tube, const EndRing& end) {
  const double t = end.at_end ? 1 : 0;
  const DiscHull disc = hull_over(tube.surface, {t, t});
  const numbers::IntervalVec& normal = disc.tangents.front();
  return {{},
          largest_angle(numbers::norm(numbers::cross(normal, end.travel())),
                        numbers::dot(normal, end.travel())),
          0,
          {}};
}

}  // namespace

TangencyClaim end_tangency(const CertifiedPiece& piece, End end) {
  return std::visit(
      [&](const auto& surface) {
        const bool at_end = end == End::end;
        const EndRing ring{at_end ? surface.end : surface.start, at_end};
        TangencyClaim result = differences(surface, ring);
        result.offset = offset(piece, ring);
        if (const auto* tube = std::get_if<RingedSurface>(&piece)) {
          result.curvature = curvature(*tube, at_end);
        }
        return result;
      },
      piece);
}

}  // namespace dupin::certification
