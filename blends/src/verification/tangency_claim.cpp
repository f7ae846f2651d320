#include "verification/tangency_claim.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "numbers/mpfi_interval.h"

namespace dupin::verification {
namespace {

using Wide = numbers::MpfiInterval<1024>;
using WideVec = std::array<Wide, 3>;

Wide dot(const WideVec& a, const WideVec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Squares of intervals about zero, unlike products with themselves, have a root.
Wide length(const WideVec& a) { return square_root(square(a[0]) + square(a[1]) + square(a[2])); }

Wide length_of_cross(const WideVec& a, const WideVec& b) {
  return length({a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]});
}

WideVec difference(const WideVec& a, const WideVec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

WideVec scaled(const Wide& s, const WideVec& a) { return {s * a[0], s * a[1], s * a[2]}; }

WideVec vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

double upper(const Wide& x) { return x.rounded_outward().upper; }

struct SpineEnd {
  WideVec position, first, second;
};

SpineEnd spine_end(const Tube& tube, End end) {
  SpineEnd result;
  if (const ArcSpine* arc = tube.arc()) {
    const Wide turned = end == End::end ? arc->angle : 0, rate = arc->angle;
    const Wide c = cosine(turned), s = sine(turned);
    const WideVec center = vector(arc->center), u = difference(vector(arc->start), center);
    const WideVec a = vector(arc->axis);
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const Wide v = a[i] * u[j] - a[j] * u[i];
      result.position[k] = center[k] + c * u[k] + s * v;
      result.first[k] = rate * (c * v - s * u[k]);
      result.second[k] = Wide(0) - rate * rate * (c * u[k] + s * v);
    }
    return result;
  }
  // Exactly, from w y = p.
  const Stretch s = tube.stretch(0, 1);
  const auto value = [end](const Polynomial& p) { return end == End::end ? p.back() : p.front(); };
  const Polynomial w1 = derivative(s.weight);
  const mpq_class w = value(s.weight);
  for (std::size_t k = 0; k < 3; ++k) {
    const Polynomial p1 = derivative(s.points[k]);
    const mpq_class y = value(s.points[k]) / w, y1 = (value(p1) - value(w1) * y) / w;
    const mpq_class y2 =
        (value(derivative(p1)) - 2 * value(w1) * y1 - value(derivative(w1)) * y) / w;
    result.position[k] = Wide(y);
    result.first[k] = Wide(y1);
    result.second[k] = Wide(y2);
  }
  return result;
}

// Bounds of the disc's differences from the ring, and of the angle of the walls.
struct Difference {
  Wide axis_angle, offset;
  std::optional<double> deviation;
};

// The greatest angle, or difference of slopes, between a wall that rises by `rise` per advance and
// one of this slope.
double deviation(const Wide& rise, const std::vector<Wide>& advances, const Wide& slope,
                 bool as_angle) {
  const double any = as_angle ? std::nextafter(std::numbers::pi, 4)  // the double above pi
                              : std::numeric_limits<double>::infinity();
  double largest = 0;
  for (const Wide& advance : advances) {
    if (!advance.is_positive()) {
      return any;
    }
    const Wide off = magnitude(rise - advance * slope);
    largest =
        std::max(largest, upper(as_angle ? angle(off, advance + rise * slope) : off / advance));
  }
  return largest;
}

struct Wall {
  double radius = 0;
  Wide slope, rise;
};

Wall wall_at(const Tube& tube, End end, double radius, double slope) {
  const Polynomial r = tube.radius(0, 1);
  const Polynomial slopes = r.empty() ? Polynomial{0} : derivative(r);
  return {radius, end == End::end ? Wide(slope) : Wide(-slope),
          Wide(end == End::end ? slopes.back() : slopes.front())};
}

Difference difference_of(const std::vector<Tube>& tubes, const Ring& ring, const WideVec& normal,
                         End end) {
  const SpineEnd y = spine_end(tubes.front(), end);
  const Wide speed = length(y.first);
  std::vector<Wall> walls{wall_at(tubes.front(), end, ring.radius, ring.slope)};
  if (tubes.size() > 1) {
    const Ellipse across = ring.ellipse.value_or(Ellipse{{}, ring.radius, ring.slope});
    walls.push_back(wall_at(tubes.back(), end, across.across, across.across_slope));
  }
  Wide reach = 0, offset = length(difference(y.position, vector(ring.center)));
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const double radius = tubes[i].radius_at(end);
    reach = std::max(upper(reach), radius);
    offset = offset + magnitude(Wide(radius) - walls[i].radius);
  }
  const Wide bend = reach * length_of_cross(y.first, y.second) / square(speed);
  const std::vector<Wide> advances{speed - bend, speed + bend};
  Wide largest = deviation(walls.front().rise, advances, walls.front().slope, walls.size() == 1);
  // Normals of elliptic walls differ by an angle whose sine is at most the difference of the
  // slopes, all around.
  if (walls.size() > 1) {
    const Wide other = deviation(walls.back().rise, advances, walls.back().slope, false);
    largest = Wide::pi() / 2 * square_root(square(largest) + square(other));
  }
  return {angle(length_of_cross(y.first, normal), dot(y.first, normal)), offset, upper(largest)};
}

Difference difference_at(const RingedSurface&, const Piece& piece, const Ring& ring,
                         const WideVec& normal, End end) {
  return difference_of(piece.tubes, ring, normal, end);
}

Difference difference_at(const EllipticTube&, const Piece& piece, const Ring& ring,
                         const WideVec& normal, End end) {
  return difference_of(piece.tubes, ring, normal, end);
}

// The tangent at the end is (2 e / D) d - tangent.
Difference difference_at(const CyclidePiece& piece, const Piece&, const Ring& ring,
                         const WideVec& normal, End end) {
  const PeVector& b = end == End::end ? piece.last : piece.first;
  WideVec m1 = vector(piece.tangent.m);
  Wide r1 = piece.tangent.r;
  if (end == End::end) {
    const WideVec d = difference(vector(piece.last.m), vector(piece.first.m));
    const Wide dr = Wide(piece.last.r) - piece.first.r;
    const Wide factor = 2 * (dot(d, m1) - dr * r1) / (dot(d, d) - square(dr));
    m1 = difference(scaled(factor, d), m1);
    r1 = factor * dr - r1;
  }
  const Wide squared = dot(m1, m1), pace = square_root(squared - square(r1));
  const WideVec center = difference(vector(b.m), scaled(b.r * r1 / squared, m1));
  const Wide radius = b.r * pace / square_root(squared);
  return {angle(length_of_cross(m1, normal), dot(m1, normal)),
          length(difference(center, vector(ring.center))) + magnitude(radius - ring.radius),
          deviation(r1, {pace}, end == End::end ? ring.slope : -ring.slope, true)};
}

Difference difference_at(const RationalRingedTube& tube, const Piece&, const Ring& ring,
                         const WideVec& normal, End end) {
  const RationalRingedSurface& surface = tube.surface;
  const auto& [w, x, y, z] = end == End::end ? surface.rotation.back() : surface.rotation.front();
  const Wide a = w, b = x, c = y, d = z;
  const WideVec axis{square(a) + square(b) - square(c) - square(d), 2 * (b * c + a * d),
                     2 * (b * d - a * c)};
  const std::size_t i = end == End::end ? 3 : 0;
  return {angle(length_of_cross(axis, normal), dot(axis, normal)),
          length(difference(vector(surface.center.at(i)), vector(ring.center))) +
              magnitude(Wide(surface.radius.at(i)) - ring.radius),
          std::nullopt};
}

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

bool is_near(const TangencyClaim& claim, const Ring& ring, double tolerance) {
  return claim.offset + claim.axis_angle * ring.radius <= tolerance;
}

bool follows(const Piece& piece, const TangencyClaim& claim, End end) {
  const bool has_none = piece.tubes.size() == 1 && piece.tubes.front().is_cone();
  if (claim.curvature &&
      !(has_none ? *claim.curvature >= 0 : curvature_follows(piece, *claim.curvature, end))) {
    return false;
  }
  spend(200);
  const Ring& ring = end == End::end ? piece.end : piece.start;
  const WideVec normal = vector(end == End::end ? ring.normal : Vec3(-ring.normal));
  const Difference found =
      std::visit([&](const auto& shape) { return difference_at(shape, piece, ring, normal, end); },
                 piece.shape);
  return upper(found.axis_angle) <= claim.axis_angle && upper(found.offset) <= claim.offset &&
         (!claim.deviation || (found.deviation && *found.deviation <= *claim.deviation));
}

}  // namespace dupin::verification
