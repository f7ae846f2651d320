#include <array>
#include <cmath>
#include <optional>

#include "verification/motions/bernstein.h"
#include "verification/motions/motion.h"

namespace dupin::verification {
namespace {

using ExactPoint = std::array<mpq_class, 4>;

// The arc's spheres are (first, middle, last) over weight, all in Bernstein form.
struct ExactArc {
  ExactPoint first, middle, last;  // the latter two times their weights
  Polynomial weight;
};

ExactPoint exact(const PeVector& b) { return {b.m.x(), b.m.y(), b.m.z(), b.r}; }

ExactPoint minus(ExactPoint a, const ExactPoint& b) {
  for (std::size_t k = 0; k < 4; ++k) {
    a[k] -= b[k];
  }
  return a;
}

mpq_class dot(const ExactPoint& a, const ExactPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] - a[3] * b[3];
}

ExactArc exact_arc(const CyclidePiece& piece) {
  const ExactPoint first = exact(piece.first), tangent = exact(piece.tangent),
                   last = exact(piece.last);
  const mpq_class chord = piece.chord;
  const ExactPoint d = minus(last, first);
  const mpq_class squared = dot(d, d), along = dot(d, tangent);
  ExactArc arc{first, {}, {}, {1, along / chord, squared / chord / chord}};
  for (std::size_t k = 0; k < 4; ++k) {
    arc.middle[k] = (along * first[k] + squared / 2 * tangent[k]) / chord;
    arc.last[k] = arc.weight[2] * last[k];
  }
  return arc;
}

using Coordinates = std::array<Polynomial, 4>;

// The weight times what the spheres are less this one.
Coordinates about_sphere(const ExactArc& arc, const ExactPoint& sphere) {
  Coordinates result;
  for (std::size_t k = 0; k < 4; ++k) {
    result[k] = about({arc.first[k], arc.middle[k], arc.last[k]}, arc.weight, sphere[k]);
  }
  return result;
}

Polynomial squared(const Coordinates& p) {
  Polynomial sum{0};
  for (std::size_t k = 0; k < 4; ++k) {
    const Polynomial term = product(p[k], p[k]);
    sum = difference(sum, k < 3 ? product(term, {-1}) : term);
  }
  return sum;
}

SphereMotion motion_of(const Curve& centers, const Polynomial& radius, const Polynomial& weight) {
  return [m_times_w = EnclosedCurve<4>(centers), r_times_w = Enclosed<4>(radius),
          weight = Enclosed<4>(weight)](double from, double to) -> std::optional<MovingSphere> {
    spend(kDiscWork);
    const Jet<4> w = weight.over(from, to);
    if (!(w[0].lower > 0)) {
      return std::nullopt;
    }
    return MovingSphere{m_times_w.over(from, to) / w, r_times_w.over(from, to) / w, w};
  };
}

}  // namespace

SphereMotion sphere_motion(const CyclidePiece& piece, double wall) {
  const ExactArc arc = exact_arc(piece);
  const auto [x, y, z, radius] =
      about_sphere(arc, {arc.first[0], arc.first[1], arc.first[2], wall});
  return motion_of({x, y, z}, radius, arc.weight);
}

SphereMotion approach(const CyclidePiece& piece) {
  const ExactArc arc = exact_arc(piece);
  Curve centers;
  Polynomial radius;
  for (std::size_t k = 0; k < 4; ++k) {
    const mpq_class last = arc.last[k] / arc.weight[2];
    const Polynomial p{arc.first[k] - last, 2 * (arc.middle[k] - arc.weight[1] * last)};
    (k < 3 ? centers[k] : radius) = p;
  }
  return motion_of(centers, radius, arc.weight);
}

namespace {

// How the circles of an arc move, (m; r) being its spheres, v = |m'|, n = m' / v and s = r' / v:
// about c = m - r s n, across n. With T = tangent, D = last - first and the weight w, w^2 (m'; r')
// is a T + b D of polynomials a and b, and a b' - a' b = k w with k = 2 <D, D>^2 / chord^3. So
//   n' = k (T x D) x n / (w^3 v^2),  s' = k n.(D_r T - T_r D) / (w^3 v^2),
//   c' = (v (1 - s^2) - r s') n - r s n',
// which are tighter where the circle hardly turns, and 0 where it does not.
// With any o = (o_m; o_r), too,
//   c'.n = (<x - o, x'>/v)' - (m - o_m).n' - o_r s',
// as (m - o_m).n - (r - o_r) s = <x - o, x'>/v for x = (m; r). For the arc's own centre this is 0
// but for what was rounded, and on straight arcs one term is left, with nothing to cancel.
class Steering {
 public:
  Steering(const CyclidePiece& piece, double wall) : Steering(exact_arc(piece), piece, wall) {}

  // v^2 - r'^2, given that, too, by what does not cancel: it has w^4 for a denominator.
  [[nodiscard]] Jet<3> pace(Jet<3> squared, const MovingSphere& sphere, double from,
                            double to) const {
    const Jet<3> exact = pace_.over(from, to) / square(square(shortened<3>(sphere.weight)));
    for (std::size_t order = 0; order < 3; ++order) {
      squared[order] = intersection(squared[order], exact[order]);
    }
    return squared;
  }

  // The derivatives of normal and centre.
  void sharpen(MovingDisc& disc, const MovingSphere& sphere, double from, double to) const {
    const Jet<2> w = shortened<2>(sphere.weight), r = shortened<2>(sphere.radius);
    const JetVec<2> m1 = shortened<2>(derivative(sphere.center));
    const Jet<2> speed = squared_norm(m1), v = sqrt(speed);
    const Jet<2> rate = constant<2>(rate_) / (w * square(w) * speed);
    JetVec<2> normal = shortened<2>(disc.normal);
    set(normal, 1,
        intersection(part(normal, 1), rate[0] * numbers::cross(across_, part(normal, 0))));
    const Jet<2> bend = rate * dot(normal, bend_);
    const Jet<2> slope{{sphere.radius[1] / v[0], bend[0]}}, set_back = r * slope;
    const JetVec<2> turning =
        rate *
        cross(JetVec<2>{constant<2>(across_[0]), constant<2>(across_[1]), constant<2>(across_[2])},
              normal);
    Jet<2> advance = v * (constant<2>(1) - square(slope)) - r * bend;
    if (off_center_) {
      const Jet<3> weight = shortened<3>(sphere.weight);
      const Jet<3> squared = weight * square(weight),
                   speed3 = squared_norm(derivative(sphere.center));
      const Jet<2> off = derivative(off_center_->over(from, to) / (squared * sqrt(speed3)));
      const Jet<2> about =
          off - dot(moved(shortened<2>(sphere.center), to_center_), turning) - height_ * bend;
      for (const std::size_t order : {0U, 1U}) {
        advance[order] = intersection(advance[order], about[order]);
      }
    }
    const JetVec<2> velocity = advance * normal - set_back * turning;
    for (const std::size_t order : {0U, 1U}) {
      set(disc.normal, order + 1, intersection(part(disc.normal, order + 1), part(turning, order)));
      set(disc.center, order + 1,
          intersection(part(disc.center, order + 1), part(velocity, order)));
    }
  }

 private:
  Steering(const ExactArc& arc, const CyclidePiece& piece, double wall) : pace_(squared_pace(arc)) {
    const ExactPoint t = exact(piece.tangent), d = minus(exact(piece.last), arc.first);
    const mpq_class weight = arc.weight[2];  // <D, D> / chord^2
    rate_ = enclosed(2 * weight * weight * piece.chord);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      across_[k] = enclosed(t[i] * d[j] - t[j] * d[i]);
      bend_[k] = enclosed(d[3] * t[k] - t[3] * d[k]);
    }
    if (const auto center = rounded_center(t, d)) {
      off_center_.emplace(off_center(arc, *center));
      for (std::size_t k = 0; k < 3; ++k) {
        to_center_[k] = -Interval((*center)[k]);
      }
      height_ = Interval((*center)[3]) + piece.first.r - wall;
    }
  }

  template <std::size_t count>
  static void set(JetVec<count>& v, std::size_t order, const IntervalVec& to) {
    for (std::size_t k = 0; k < 3; ++k) {
      v[k][order] = to[k];
    }
  }

  // Of the arc less its first sphere, in doubles; none where it has none, or too far away.
  static std::optional<std::array<double, 4>> rounded_center(const ExactPoint& t,
                                                             const ExactPoint& d) {
    const mpq_class unit = dot(t, t), along = dot(t, d), squared = dot(d, d);
    const mpq_class determinant = unit * squared - along * along;
    if (determinant == 0) {
      return std::nullopt;
    }
    const mpq_class share = squared / (2 * determinant);
    std::array<double, 4> center;
    for (std::size_t k = 0; k < 4; ++k) {
      center[k] = mpq_class(share * (unit * d[k] - along * t[k])).get_d();
      if (!std::isfinite(center[k])) {
        return std::nullopt;
      }
    }
    return center;
  }

  static Polynomial squared_pace(const ExactArc& arc) {
    const Polynomial slowing = derivative(arc.weight);
    Coordinates rates = about_sphere(arc, arc.first);
    for (Polynomial& p : rates) {
      p = difference(product(derivative(p), arc.weight), product(p, slowing));
    }
    return squared(rates);
  }

  // w^3 <x - o, x'>: with y = w (x - o) and any number c, of q = <y, y> - c w^2 it is
  // w q' / 2 - w' q, and where o is the centre, q is 0.
  static Polynomial off_center(const ExactArc& arc, const std::array<double, 4>& center) {
    ExactPoint o = arc.first;
    for (std::size_t k = 0; k < 4; ++k) {
      o[k] += center[k];
    }
    Polynomial q = squared(about_sphere(arc, o));
    q = about(q, product(arc.weight, arc.weight), q.front());
    return difference(product(arc.weight, product(derivative(q), {mpq_class(1, 2)})),
                      product(derivative(arc.weight), q));
  }

  Interval rate_, height_;
  IntervalVec across_, bend_, to_center_;
  Enclosed<3> pace_;
  std::optional<Enclosed<3>> off_center_;
};

// Circles lie on their spheres, however wide the intervals are that they are computed from.
void keep_within_sphere(MovingDisc& disc, const JetVec<1>& center, const Interval& radius) {
  const Interval sine(-1, 1);
  for (std::size_t k = 0; k < 3; ++k) {
    disc.normal[k][0] = intersection(disc.normal[k][0], sine);
    disc.center[k][0] = intersection(disc.center[k][0], center[k][0] + radius * sine);
  }
  disc.radius[0] = intersection(disc.radius[0], radius * sine);
}

}  // namespace

Motion motion(const CyclidePiece& piece, double wall) {
  return [base = numbers::interval_vec(piece.first.m), spheres = sphere_motion(piece, wall),
          steering = Steering(piece, wall)](double from, double to) -> std::optional<MovingDisc> {
    const auto sphere = spheres(from, to);
    if (!sphere) {
      return std::nullopt;
    }
    const JetVec<3> m1 = derivative(sphere->center);
    const Jet<3> r1 = derivative(sphere->radius), speed = squared_norm(m1);
    const Jet<3> squared_pace = steering.pace(speed - square(r1), *sphere, from, to);
    if (!(speed[0].lower > 0 && squared_pace[0].lower > 0)) {
      return std::nullopt;
    }
    const Jet<3> pace = sqrt(squared_pace), value = shortened<3>(sphere->radius);
    const JetVec<3> center = shortened<3>(sphere->center);
    const JetVec<3> shift = (value * r1 / speed) * m1;
    MovingDisc disc{moved(center - shift, base), m1 / sqrt(speed), value * pace / sqrt(speed),
                    pace};
    keep_within_sphere(disc, shortened<1>(moved(center, base)), value[0]);
    steering.sharpen(disc, *sphere, from, to);
    return disc;
  };
}

}  // namespace dupin::verification
