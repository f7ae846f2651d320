#include "verification/claims/mesh_claim.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "verification/admitted.h"
#include "verification/work.h"

namespace dupin::verification {
namespace {

constexpr int kRefinements = 10;  // a band's bounds are taken over up to 2^10 cells

// e' = omega x e for the directions e from the centre c, hence
//   x_tt = c'' + R'' e + 2 R' omega x e + R (omega' x e + omega x (omega x e)),
//   x_tu = R' e_u + R omega x e_u.
void include_spinning(BandBounds& bounds, const MovingDisc& disc) {
  const auto& [omega, change] = *disc.spin;
  const Interval rate = numbers::norm(omega), slope = disc.radius[1].magnitude();
  const Interval radius = disc.radius[0].magnitude();
  const Interval along = numbers::norm(part(disc.center, 2)) + disc.radius[2].magnitude() +
                         Interval(2) * slope * rate +
                         radius * (numbers::norm(change) + square(rate));
  bounds.along = std::max(bounds.along, along.upper);
  bounds.mixed = std::max(bounds.mixed, (slope + radius * rate).upper);
  bounds.around = std::max(bounds.around, radius.upper);
}

// e' = -(e.n') n for the directions e from the centre c, hence
//   x_tt = [c''.n - 2 R' e.n' - R e.n''] n + the rest of c'' + R'' e - R (e.n') n',
//   x_tu = R' e_u - R (e_u.n') n.
void include_steady(BandBounds& bounds, const MovingDisc& disc, const Jet<2>& pace) {
  const Jet<1> value{{pace[0]}};
  const JetVec<2> c1 = derivative(disc.center) / pace, n1 = derivative(disc.normal) / pace;
  const Jet<2> r1 = derivative(disc.radius) / pace;
  const IntervalVec n = part(disc.normal, 0);
  const IntervalVec c2 = part(derivative(c1) / value, 0), n2 = part(derivative(n1) / value, 0);
  const Interval turn = numbers::norm(part(n1, 0)), slope = r1[0].magnitude();
  const Interval radius = disc.radius[0].magnitude(),
                 bend = (derivative(r1) / value)[0].magnitude();
  const Interval lengthwise = Interval(numbers::dot(c2, n).magnitude()) +
                              Interval(2) * slope * turn +
                              radius * numbers::norm(numbers::cross(n2, n));
  const Interval across = numbers::norm(numbers::cross(c2, n)) + bend + radius * square(turn);
  bounds.along = std::max(bounds.along, numbers::sqrt(square(lengthwise) + square(across)).upper);
  bounds.mixed = std::max(bounds.mixed, numbers::sqrt(square(slope) + square(radius * turn)).upper);
  bounds.around = std::max(bounds.around, radius.upper);
  bounds.turning = std::max(bounds.turning, turn.upper);
}

void include(BandBounds& bounds, const MovingDisc& disc, Measure measure, const Interval& step) {
  const bool is_by_length = measure == Measure::length;
  const Interval pace = is_by_length ? disc.pace[0] : Interval(1);
  bounds.length = (bounds.length + step * pace).upper;
  if (disc.spin) {
    include_spinning(bounds, disc);
  } else {
    include_steady(bounds, disc, {{pace, is_by_length ? disc.pace[1] : Interval(0)}});
  }
}

}  // namespace

std::optional<std::array<BandBounds, 2>> bounds_over(const Motion& motion, double from, double to,
                                                     int cells) {
  std::array<BandBounds, 2> bounds;
  for (int i = 0; i < cells; ++i) {
    const double a = i == 0 ? from : std::lerp(from, to, double(i) / cells);
    const double b = i + 1 == cells ? to : std::lerp(from, to, double(i + 1) / cells);
    const auto disc = motion(a, b);
    if (!disc) {
      return std::nullopt;
    }
    include(bounds[0], *disc, Measure::length, Interval(b) - a);
    include(bounds[1], *disc, Measure::parameter, Interval(b) - a);
  }
  return bounds;
}

namespace {

// The design of the bound is in docs/certificate_format.md: linear interpolation on right triangles
// with legs dt and du, du widened by the frame's drift over a band and the tube's share of twist.
bool is_within(const BandBounds& bounds, const Interval& around, double allowed) {
  const Interval dt = bounds.length, turn = dt * bounds.turning;
  const Interval du = around + Interval(0.27) * square(turn) / 16;
  const Interval error = (square(dt) * bounds.along + Interval(2) * dt * du * bounds.mixed +
                          square(du) * bounds.around) /
                         8;
  return turn.upper <= 1 && error.upper <= allowed;
}

bool band_follows(const Motion& motion, double from, double to, std::uint32_t segments,
                  const Interval& twist, double allowed) {
  const Enclosure pi = Mpfi::pi().rounded_outward();
  const Interval around = Interval(2) * Interval(pi.lower, pi.upper) / segments + twist;
  for (int cells = 1; cells <= 1 << kRefinements; cells *= 2) {
    const auto bounds = bounds_over(motion, from, to, cells);
    if (bounds && std::any_of(bounds->begin(), bounds->end(), [&](const BandBounds& its) {
          return is_within(its, around, allowed);
        })) {
      return true;
    }
  }
  return false;
}

// Whether two semi-axes, each at the start and at the end, keep their ratio.
bool are_similar(const std::array<double, 2>& first, const std::array<double, 2>& second) {
  return mpq_class(first[0]) * mpq_class(second[1]) == mpq_class(first[1]) * mpq_class(second[0]);
}

std::array<double, 2> end_radii(const Tube& tube) {
  return {tube.radius_at(End::start), tube.radius_at(End::end)};
}

// Where the axes are the same at both ends: `turn` is then a multiple of pi but for rounding.
bool is_turned(const Piece& piece) {
  const auto* tube = std::get_if<EllipticTube>(&piece.shape);
  return tube != nullptr && !(std::abs(tube->turn) < 1);
}

// A cylinder or cone between rings that look the same way: of ellipses, similar ones with the same
// axes, by their stored rings and by the radii between them.
bool is_straight(const Piece& piece) {
  const Ring &a = piece.start, &b = piece.end;
  const auto& tubes = piece.tubes;
  return !tubes.empty() &&
         std::all_of(tubes.begin(), tubes.end(), [](const Tube& t) { return t.is_cone(); }) &&
         b.normal == -a.normal &&
         (tubes.size() == 1 ||
          (a.ellipse && b.ellipse && a.ellipse->axis == b.ellipse->axis && !is_turned(piece) &&
           are_similar({a.radius, b.radius}, {a.ellipse->across, b.ellipse->across}) &&
           are_similar(end_radii(tubes[0]), end_radii(tubes[1]))));
}

bool ascends(const std::vector<double>& knots) {
  return std::adjacent_find(knots.begin(), knots.end(),
                            [](double a, double b) { return !(a < b); }) == knots.end();
}

double largest_radius(const Piece& piece) {
  double largest = 0;
  for (const Tube& tube : piece.tubes) {
    largest = std::max(largest, tube.radius_range(0, 1).magnitude());
  }
  return largest;
}

// How much nearer to the centre than the radius the middle of a chord is.
double sagitta(double radius, std::uint32_t segments) {
  const Mpfi depth = Mpfi(radius) * (1 - cosine(Mpfi::pi() / double(segments)));
  return depth.rounded_outward().upper;
}

// What columns turn by on a band: the half segment that the last ring may ask for is shared by so
// many, unless it is said, as where pieces do not meet in rings.
Interval twist_of(const MeshClaim& claim, std::size_t sharing) {
  if (claim.kneecaps) {
    return claim.kneecaps->turn;
  }
  const Enclosure twist = (Mpfi::pi() / double(claim.segments) / double(sharing)).rounded_outward();
  return {twist.lower, twist.upper};
}

bool piece_follows(const Piece& piece, const Motion& motion, const std::vector<double>& knots,
                   std::uint32_t segments, const Interval& twist, double allowed) {
  if (knots.size() == 2 && is_straight(piece)) {
    return sagitta(largest_radius(piece), segments) <= allowed;
  }
  if (!motion) {
    return false;  // nothing is known of how the axes of ellipses turn
  }
  return holds_of_all(knots.size() - 1, [&](std::size_t i) {
    return band_follows(motion, knots[i], knots[i + 1], segments, twist, allowed);
  });
}

// How large the coordinates may be.
double size_over(const Solid& solid, const ParameterInterval& t, int halvings) {
  if (const auto discs = solid.discs(t)) {
    double size = discs->radius.magnitude();
    for (const IntervalVec& center : discs->centers) {
      size = std::max(size, numbers::norm(center).upper);
    }
    return size;
  }
  const double middle = (t.from + t.to) / 2;
  return halvings == 0 ? std::numeric_limits<double>::infinity()
                       : std::max(size_over(solid, {t.from, middle}, halvings - 1),
                                  size_over(solid, {middle, t.to}, halvings - 1));
}

// Of the ellipses; 0 where there is none.
double longest_axis(const Solid& solid) {
  double longest = 0;
  for (const Piece& piece : solid.pieces()) {
    longest = std::max(longest, piece.tubes.size() > 1 ? largest_radius(piece) : 0);
  }
  return longest;
}

enum class Skin { outer, inner };

// Those of each piece, from 0 to 1 by its own parameter; none where they are not.
std::optional<std::vector<std::vector<double>>> knots_of_pieces(const std::vector<double>& all,
                                                                std::size_t pieces) {
  std::vector<std::vector<double>> result(pieces);
  auto knot = all.begin();
  for (std::size_t i = 0; i < pieces; ++i) {
    std::vector<double>& knots = result[i];
    for (; knot != all.end() && (knots.empty() || knots.back() < 1); ++knot) {
      knots.push_back(*knot - double(i));
    }
    if (knots.size() < 2 || knots.front() != 0 || knots.back() != 1 || !ascends(knots)) {
      return std::nullopt;
    }
    --knot;
  }
  return knot + 1 == all.end() ? std::optional(std::move(result)) : std::nullopt;
}

bool skin_follows(const Solid& solid, const MeshClaim& claim, const std::vector<double>& all,
                  Skin skin, double allowed) {
  const auto knots = knots_of_pieces(all, solid.pieces().size());
  return knots && holds_of_all(knots->size(), [&](std::size_t i) {
           const Piece& piece = solid.pieces()[i];
           const std::vector<double>& its = (*knots)[i];
           const std::size_t sharing = (piece.shares_frame ? all.size() : its.size()) - 1;
           return piece_follows(piece, skin == Skin::inner ? piece.inner : piece.motion, its,
                                claim.segments, twist_of(claim, sharing), allowed);
         });
}

// Between the rows at both ends, quadrilaterals of which two sides are parallel: they lie in planes
// and are as far from the cone as the outer circle's chords, of which its bands have told.
bool has_rims(const Solid& solid) {
  const auto has_circle = [](const Piece& piece, double t) {
    const auto disc = piece.inner(t, t);
    return disc && disc->radius[0].lower >= 0;
  };
  return !solid.closed() && has_circle(solid.pieces().front(), 0) &&
         has_circle(solid.pieces().back(), 1);
}

// What a ball has between two planes is convex, so that triangles with corners on it are inside.
bool kneecaps_follow(const Solid& solid, const KneecapMesh& claim, double allowed) {
  const std::vector<Sphere>& knees = solid.knees();
  if (!is_bound(claim.turn) || !is_bound(claim.apart) ||
      claim.segments.size() != knees.size() * (solid.wall() > 0 ? 2 : 1)) {
    return false;
  }
  for (std::size_t i = 0; i < claim.segments.size(); ++i) {
    const bool is_inner = i >= knees.size();
    const Sphere& knee = knees[is_inner ? i - knees.size() : i];
    const double radius = is_inner ? (Interval(knee.radius) - solid.wall()).upper : knee.radius;
    const std::uint32_t segments = claim.segments[i];
    if (segments < 3 || segments > CertificateLimits::kSegments ||
        !(sagitta(radius, segments) <= allowed)) {
      return false;
    }
  }
  return true;
}

// No point of a facet of the graticule is nearer to the centre than its plane.
bool sphere_follows(const Sphere& sphere, const MeshClaim& claim) {
  if (!claim.knots.empty()) {
    return false;
  }
  const std::uint32_t bands = (claim.segments + 1) / 2;
  const Mpfi step = Mpfi::pi() / double(bands);
  const Mpfi half = cosine(Mpfi::pi() / double(claim.segments));
  // Of a band about the polar angle m that is half sin(step) / (2 sin(step/2) sqrt(half^2 cos^2 m +
  // sin^2 m)): least for the band nearest to the equator.
  const std::uint32_t nearest_band = (bands - 1) / 2;
  const double i = nearest_band;
  const Mpfi a = step * i, b = step * (i + 1);
  const Mpfi xa = half * sine(a), xb = half * sine(b), za = cosine(a), zb = cosine(b);
  const Mpfi plane = magnitude(xa * zb - xb * za) / square_root(square(xb - xa) + square(zb - za));
  const double nearest = std::min(1., plane.rounded_outward().lower);
  const Interval sag = Interval(sphere.radius) * (Interval(1) - nearest);
  const double size = std::max(sphere.radius, sphere.center.norm());
  return (sag + displacement(claim.grid, size)).upper <= claim.error_bound;
}

}  // namespace

bool is_of_chain(const MeshClaim& claim) {
  return !claim.inner_knots.empty() || claim.kneecaps.has_value();
}

Interval displacement(double grid, double size) {
  return numbers::sqrt(Interval(3)) / 2 * grid + Interval(std::ldexp(size, -47));
}

double size_of(const Solid& solid) {
  constexpr double kCells = 4;
  constexpr int kHalvings = 10;
  std::vector<double> sizes(std::size_t(kCells * solid.length()));
  (void)holds_of_all(sizes.size(), [&](std::size_t i) {
    sizes[i] = size_over(solid, {double(i) / kCells, double(i + 1) / kCells}, kHalvings);
    return true;
  });
  double size = sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end());
  for (const Sphere& knee : solid.knees()) {
    size = std::max(size, numbers::norm(numbers::interval_vec(knee.center)).upper);
  }
  return size;
}

bool follows(const Solid& solid, const MeshClaim& claim) {
  if (!is_bound(claim.grid) || !is_bound(claim.error_bound) || !is_bound(claim.axes) ||
      claim.segments < 3 || claim.segments > CertificateLimits::kSegments) {
    return false;
  }
  const double longest = longest_axis(solid);
  if (longest == 0 && claim.axes != 0) {
    return false;  // of no ellipse
  }
  if (solid.ball() != nullptr) {
    return !is_of_chain(claim) && sphere_follows(*solid.ball(), claim);
  }
  if (solid.has_kneecaps() != claim.kneecaps.has_value()) {
    return false;
  }
  const Interval turned = Interval(claim.axes) * longest;
  const Interval apart = claim.kneecaps ? claim.kneecaps->apart : 0;
  const Interval moved = displacement(claim.grid, size_of(solid) + solid.wall());
  const double allowed = (Interval(claim.error_bound) - turned - apart - moved).lower;
  return skin_follows(solid, claim, claim.knots, Skin::outer, allowed) &&
         (solid.wall() > 0 ? has_rims(solid) &&
                                 skin_follows(solid, claim, claim.inner_knots, Skin::inner, allowed)
                           : claim.inner_knots.empty()) &&
         (!claim.kneecaps || kneecaps_follow(solid, *claim.kneecaps, allowed));
}

}  // namespace dupin::verification
