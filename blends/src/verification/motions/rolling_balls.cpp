#include "verification/motions/rolling_balls.h"

#include <algorithm>
#include <numeric>
#include <variant>

namespace dupin::verification {
namespace {

using numbers::dot;

// Cosine and sine of the angle whose tangent is x / (1 - x), and of its double less pi/2.
struct Place {
  explicit Place(double x) {
    const Interval rest = Interval(1) - x;
    const Interval length = sqrt(square(rest) + square(Interval(x)));
    cosine = rest / length;
    sine = Interval(x) / length;
  }
  [[nodiscard]] Interval double_sine() const { return Interval(2) * sine * cosine; }
  [[nodiscard]] Interval minus_double_cosine() const { return square(sine) - square(cosine); }

  Interval cosine, sine;
};

// How much the angle grows at most between two places of one half.
double growth(double from, double to) {
  const double nearest = std::clamp(0.5, from, to);
  const Interval squared = square(Interval(1) - nearest) + square(Interval(nearest));
  return (Interval(2) * (Interval(to) - from) / squared).upper;
}

// A direction, or, of weight 1, a point by its place beside the first ring's centre.
struct Homogeneous {
  IntervalVec at;
  Interval weight;
};

// Of the form that is 0 where points are on the first cone: |w|^2 - (w.n)^2 - (r + q w.n)^2.
class ConeForm {
 public:
  explicit ConeForm(const Ring& ring)
      : normal_(interval_vec(ring.normal)), radius_(ring.radius), slope_(ring.slope) {}

  [[nodiscard]] Interval operator()(const Homogeneous& a, const Homogeneous& b) const {
    const Interval an = dot(a.at, normal_), bn = dot(b.at, normal_);
    return dot(a.at, b.at) - an * bn -
           (radius_ * a.weight + slope_ * an) * (radius_ * b.weight + slope_ * bn);
  }

 private:
  IntervalVec normal_;
  Interval radius_, slope_;
};

}  // namespace

// All differences are exact: the middle is the double that is the stretch's, whatever its half.
std::optional<TurnStretch> turn_stretch(const ParameterInterval& t) {
  const double half = t.from < 1 ? 0 : 1;
  const double from = t.from - half, to = t.to - half, at = std::midpoint(t.from, t.to) - half;
  if (!(from >= 0 && from <= to && to <= 1 && half <= 1)) {
    return std::nullopt;
  }
  const Place first(from), middle(at), last(to);
  const Interval falling{last.cosine.lower, first.cosine.upper};  // cosine and sine of the rest
  const Interval rising{first.sine.lower, last.sine.upper};
  Interval cosine = hull(first.double_sine(), last.double_sine());
  if (from <= 0.5 && to >= 0.5) {
    cosine = hull(cosine, 1);
  }
  const Interval sine = hull(first.minus_double_cosine(), last.minus_double_cosine());
  const double length = growth(from, to), reach = std::max(growth(from, at), growth(at, to));
  const Interval middle_cosine = middle.double_sine(), middle_sine = middle.minus_double_cosine();
  if (half == 0) {
    return TurnStretch{
        {cosine, sine, middle_cosine, middle_sine, reach}, falling, rising, 1, length};
  }
  return TurnStretch{
      {-cosine, -sine, -middle_cosine, -middle_sine, reach}, -rising, falling, -1, length};
}

bool rolls_on_cones(const CanalFillet& loop) {
  return std::holds_alternative<RollingOnCones>(loop.motion) ||
         std::holds_alternative<RollingPartlyOnCones>(loop.motion);
}

// With the form Q, the generator's points a + h b have Q(b, b) h^2 + 2 Q(a, b) h + Q(a, a) = 0, and
// what is asked for is Q(a, b)^2 - Q(a, a) Q(b, b): less the square of the bivector of a and b.
// With a = A + R u and b = B + s u, where u turns, this is A ^ B + (s A - R B) ^ u.
AngleWave discriminant(const RollingOnCones& motion) {
  const Ring &one = motion.first, &two = motion.second;
  const ConeForm form(one);
  const IntervalVec center = interval_vec(two.center) - interval_vec(one.center);
  const IntervalVec axis = interval_vec(two.normal);
  const Interval radius = two.radius, slope = two.slope;
  const Homogeneous a{center, 1}, b{axis, 0}, e{slope * center - radius * axis, slope};
  const std::array<Homogeneous, 2> u{
      {{interval_vec(motion.zero), 0}, {interval_vec(motion.quarter), 0}}};
  const auto mixed = [&](const Homogeneous& turning) {
    return form(a, e) * form(b, turning) - form(a, turning) * form(b, e);
  };
  const auto turned = [&](std::size_t i, std::size_t k) {
    return form(e, e) * form(u.at(i), u.at(k)) - form(e, u.at(i)) * form(e, u.at(k));
  };
  const Interval still = form(a, a) * form(b, b) - square(form(a, b));
  const Interval first = turned(0, 0), second = turned(1, 1);
  return {-(still + (first + second) / 2), Interval(-2) * mixed(u[0]), Interval(-2) * mixed(u[1]),
          (second - first) / 2, -turned(0, 1)};
}

}  // namespace dupin::verification
