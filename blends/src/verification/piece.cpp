#include "verification/piece.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "verification/admitted.h"

namespace dupin::verification {
namespace {

// The numbers of each kind.
struct Admission {
  const Requirements& needs;

  void operator()(const RingedSurface& s) const {
    needs.ring(s.start);
    needs.ring(s.end);
    needs.spine(s.spine);
    needs.radius(s.radius);
  }

  void operator()(const EllipticTube& s) const {
    (*this)(RingedSurface{s.start, s.end, s.spine, s.first});
    needs.radius(s.second);
    needs.number(s.turn);
  }

  void operator()(const CyclidePiece& s) const {
    needs.ring(s.start);
    needs.ring(s.end);
    for (const PeVector& sphere : {s.first, s.tangent, s.last}) {
      needs.point(sphere.m);
      needs.number(sphere.r);
    }
    needs.positive(s.chord, "chord");
  }

  void operator()(const RationalRingedTube& s) const {
    needs.ring(s.start);
    needs.ring(s.end);
    for (const Vec3& center : s.surface.center) {
      needs.point(center);
    }
    for (const double radius : s.surface.radius) {
      needs.number(radius);
    }
    needs.require(s.surface.rotation.size() >= 2, "rotation");
    needs.coefficients(s.surface.rotation.size());
    for (const auto& control : s.surface.rotation) {
      std::for_each(control.begin(), control.end(), [this](double x) { needs.number(x); });
    }
  }
};

Interval largest_radius(const std::vector<Tube>& tubes, double from, double to) {
  Interval result = tubes.front().radius_range(from, to);
  for (const Tube& tube : tubes) {
    result = max(result, tube.radius_range(from, to));
  }
  return result;
}

void read(const RingedSurface& surface, double, Piece& result) {
  result.tubes = {Tube(surface)};
  result.steered = result.motion = motion(result.tubes.front());
}

void read(const EllipticTube& tube, double, Piece& result) {
  result.tubes = {Tube({tube.start, tube.end, tube.spine, tube.first}),
                  Tube({tube.start, tube.end, tube.spine, tube.second})};
  const Motion about = motion(result.tubes.front());
  result.motion = motion(tube, about, result.tubes.back());
  result.steered = [about, axes = result.tubes](double from, double to) {
    auto disc = about(from, to);
    if (disc) {
      disc->radius[0] = largest_radius(axes, from, to);
    }
    return disc;
  };
}

void read(const CyclidePiece& piece, double wall, Piece& result) {
  result.steered = result.motion = motion(piece, 0);
  result.inner = wall > 0 ? motion(piece, wall) : Motion();
  result.shares_frame = true;
}

void read(const RationalRingedTube& tube, double, Piece& result) {
  result.motion = motion(tube.surface);
  result.steered = steered_motion(tube.surface);
}

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

EndDifference difference_of(const std::vector<Tube>& tubes, const Ring& ring, const WideVec& normal,
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

EndDifference difference_at(const RingedSurface&, const Piece& piece, const Ring& ring,
                            const WideVec& normal, End end) {
  return difference_of(piece.tubes, ring, normal, end);
}

EndDifference difference_at(const EllipticTube&, const Piece& piece, const Ring& ring,
                            const WideVec& normal, End end) {
  return difference_of(piece.tubes, ring, normal, end);
}

// The tangent at the end is (2 e / D) d - tangent.
EndDifference difference_at(const CyclidePiece& piece, const Piece&, const Ring& ring,
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

EndDifference difference_at(const RationalRingedTube& tube, const Piece&, const Ring& ring,
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

// A wall as it is from a quadric: about points y on the axis, `aside` from the quadric's, of the
// radius R, R - r - q h(y) being what a ring of that radius there would be off.
struct Misfit {
  Wide off = 0, aside = 0, least_radius, largest_radius;
};

// All of it is affine or convex along the line, and so largest at an end.
Misfit misfit_of(const Ring& quadric, const WideVec& axis, const Tube& cone,
                 const LineSpine& line) {
  Misfit result;
  const double start = cone.radius_at(End::start), end = cone.radius_at(End::end);
  for (const auto& [place, radius] : {std::pair(line.from, start), std::pair(line.to, end)}) {
    const WideVec from = difference(vector(place), vector(quadric.center));
    const Wide height = dot(from, axis), aside = length(difference(from, scaled(height, axis)));
    const Wide off = magnitude(Wide(radius) - quadric.radius - quadric.slope * height);
    result.off = std::max(upper(result.off), upper(off));
    result.aside = std::max(upper(result.aside), upper(aside));
  }
  result.least_radius = std::min(start, end);
  result.largest_radius = std::max(start, end);
  return result;
}

}  // namespace

// The proof is in docs/certificate_format.md, under contact.
ConeDifference difference_from(const Ring& quadric, const Tube& cone) {
  constexpr double kMoreThanHalfPi = 1.6;  // an angle is at most so many times its chord
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto* line = std::get_if<LineSpine>(&cone.surface().spine);
  if (!cone.is_cone() || line == nullptr) {
    return {kInfinity, kInfinity};
  }
  const WideVec stored = vector(quadric.normal),
                along = difference(vector(line->to), vector(line->from));
  const Wide whole = length(along);
  const WideVec axis = scaled(1 / length(stored), stored), tangent = scaled(1 / whole, along);
  const Misfit misfit = misfit_of(quadric, axis, cone, *line);
  const Wide lean = length_of_cross(tangent, axis), slope = magnitude(Wide(quadric.slope));
  const Wide rise = (Wide(cone.radius_at(End::end)) - cone.radius_at(End::start)) / whole;
  const Wide share = lean * (lean + slope), rest = 1 - share;
  const Wide offset = (misfit.off + misfit.aside + share * misfit.largest_radius) / rest;
  const Wide nearest = misfit.least_radius - offset;
  if (!dot(tangent, axis).is_positive() || !rest.is_positive() || !nearest.is_positive()) {
    return {kInfinity, kInfinity};
  }
  const Wide chord = 2 * (misfit.aside / nearest + lean) + magnitude(rise - quadric.slope) +
                     magnitude(rise) * lean;
  return {upper(offset), upper(kMoreThanHalfPi * chord)};
}

Piece::Piece(const dupin::Piece& certified, double wall) : shape(certified) {
  std::visit(
      [&](const auto& piece) {
        start = piece.start;
        end = piece.end;
        read(piece, wall, *this);
      },
      shape);
}

// Centres by the mean value theorem from the middle, normals by how far they turn from there.
std::optional<Discs> discs_of(const Piece& piece, const ParameterInterval& t) {
  if (!piece.tubes.empty()) {
    Discs result = piece.tubes.front().discs(t.from, t.to);
    result.radius = largest_radius(piece.tubes, t.from, t.to);
    return result;
  }
  const double middle = (t.from + t.to) / 2;
  const auto here = piece.motion(middle, middle), all = piece.motion(t.from, t.to);
  if (!here || !all) {
    return std::nullopt;
  }
  const Interval half =
      std::max((Interval(t.to) - middle).upper, (Interval(middle) - t.from).upper);
  const IntervalVec center = part(here->center, 0), step = half * part(all->center, 1);
  return Discs{{center - step, center + step},
               {part(here->normal, 0)},
               all->radius[0],
               (half * numbers::norm(part(all->normal, 1))).upper};
}

void admit(const dupin::Piece& certified, const Requirements& requirements) {
  std::visit(Admission{requirements}, certified);
}

EndDifference end_difference(const Piece& piece, End end) {
  const Ring& ring = end == End::end ? piece.end : piece.start;
  const WideVec normal = vector(end == End::end ? ring.normal : Vec3(-ring.normal));
  return std::visit(
      [&](const auto& shape) { return difference_at(shape, piece, ring, normal, end); },
      piece.shape);
}

}  // namespace dupin::verification
