#include "canal/ball_on_cylinders.h"

#include <algorithm>
#include <cmath>

#include "numbers/cosine_and_sine.h"

namespace dupin::canal {

using numbers::Interval;
using numbers::IntervalVec;

namespace {

IntervalVec times(const std::array<IntervalVec, 3>& columns, const IntervalVec& v) {
  return v[0] * columns[0] + v[1] * columns[1] + v[2] * columns[2];
}

/// The root of 1 - x^2 with the sign of another number.
Interval beside(const Interval& x, const Interval& sign) {
  const Interval size = sqrt(intersection(Interval(1) - square(x), {0, 1}));
  const bool positive = sign.upper > 0;
  return {positive && sign.lower >= 0 ? size.lower : -size.upper,
          positive ? size.upper : -size.lower};
}

/// a / (a + b) of numbers that are not negative: it grows with a and falls with b.
Interval share(const Interval& a, const Interval& b) {
  const Interval low = Interval(a.lower) / (Interval(a.lower) + Interval(b.upper));
  const Interval high = Interval(a.upper) / (Interval(a.upper) + Interval(b.lower));
  return {std::max(low.lower, 0.0), std::min(high.upper, 1.0)};
}

/// Upper bounds of a function's magnitude and of its derivatives'.
struct Most {
  Interval value, rate, acceleration;
};

/// R = sqrt(gap + w sin^2 x), and as well with the cosine. R' = w sin x cos x / R <= sqrt(w), and
/// R'' = (gap w cos 2x - w^2 sin^4 x) / R^3, where R^2 >= gap and R^2 >= w sin^2 x.
Most most_of_root(double gap, const Interval& w) {
  const Interval root = sqrt(w);
  return {sqrt(Interval(gap) + w), root, gap > 0 ? w / sqrt(Interval(gap)) + root : root};
}

}  // namespace

// Where sine^2 + cosine^2 is 1 but for rounding, the stored axis is scaled.
template <class Motion>
BallOnCylinders::Frame BallOnCylinders::frame_of(const Motion& motion) {
  const Interval cosine = motion.cosine;
  const Interval sine = sqrt((Interval(1) - cosine) * (Interval(1) + cosine));
  return {numbers::interval_vec(motion.origin),
          {sine / motion.sine * numbers::interval_vec(motion.along),
           numbers::interval_vec(motion.across), numbers::interval_vec(motion.up)},
          cosine,
          sine};
}

// y^2 = (below + d - d sin)(above + d + d sin) = r^2 - (d sin - shift)^2, with r = d + half the
// sum of both and half their difference. The projection along the second axis moves on a circle of
// radius d by the parameter.
BallOnCylinders::BallOnCylinders(const RollingThrough& motion)
    : frame_(frame_of(motion)), radius_(motion.radius), side_(motion.side) {
  const Interval half = 0.5, d = motion.distance;
  const auto [below, above] = std::pair<Interval, Interval>(motion.below, motion.above);
  const Interval shift = half * (below - above), first = d + half * (below + above);
  cylinders_ = {Cylinder{first, shift - motion.height}, Cylinder{d, -Interval(motion.height)}};
  scale_ = {d / first, 1};
  shift_ = shift / first;
  // By half the parameter.
  const Most p = most_of_root(motion.below, Interval(2) * d);
  const Most q = most_of_root(motion.above, Interval(2) * d);
  const Interval bend =
      (p.acceleration * q.value + Interval(2) * p.rate * q.rate + p.value * q.acceleration) /
      Interval(4);
  curvature_ = ((d + bend) / frame_.sine + bend + d) / square(d);
}

// z + d1 = Z = w sin^2 and y^2 = Z (first + w - Z): a circle of the diameter first + w, passed
// with the speed sqrt(w (first + w)) |cos| at least. As well on the second one, with cosines.
BallOnCylinders::BallOnCylinders(const RollingPartly& motion)
    : frame_(frame_of(motion)), radius_(motion.radius), passes_(false) {
  const Interval half = 0.5, two = 2, w = motion.overlap;
  const Interval first = half * (motion.first + w), second = half * (motion.second + w);
  cylinders_ = {Cylinder{first, first - motion.distance},
                Cylinder{second, w - motion.distance - second}};
  scale_ = {w / first, w / second};
  const auto bend = [&](double gap) {
    const Most root = most_of_root(gap, w);
    return sqrt(w) * (root.value + two * root.rate + root.acceleration);
  };
  const Interval y = bend(motion.first);
  curvature_ = ((bend(motion.second) + y) / frame_.sine + y + two * w) / (w * min(first, second));
}

Interval BallOnCylinders::reach_along_axes() const {
  return (cylinders_[0].radius + cylinders_[1].radius) / frame_.sine;
}

/// Of axes^T axes from the identity.
Interval BallOnCylinders::error_of_frame() const {
  Interval sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      sum = sum + square(dot(frame_.axes[i], frame_.axes[j]) - Interval(i == j ? 1 : 0));
    }
  }
  return sqrt(sum);
}

// With A for the axes, u = o + h a + d n (o on the axis and orthogonal to it, a its direction) and
// P x = x - (x.b) b for the stored direction b, the normal at the foot is P (origin + A u - center)
// / reach. It is off A n by
//   (P (origin + A o - center) + h P A a + (d - reach) A n - d b (b.A n)) / reach,
// and b.A n = (A^T b -+ a).n.
Interval BallOnCylinders::error_of_normal(std::size_t i, const Ring& stored) const {
  const IntervalVec axis = numbers::interval_vec(stored.normal);
  const IntervalVec own =
      i == 0 ? IntervalVec{1, 0, 0} : IntervalVec{frame_.cosine, frame_.sine, 0};
  const auto across = [&](const IntervalVec& v) { return v - dot(v, axis) * axis; };
  const auto& [radius, height] = cylinders_.at(i);
  const IntervalVec along = times(frame_.axes, own);
  const Interval sign = dot(along, axis).lower > 0 ? 1 : -1;
  const IntervalVec back{dot(frame_.axes[0], axis), dot(frame_.axes[1], axis),
                         dot(frame_.axes[2], axis)};
  const IntervalVec off =
      across(frame_.origin + height * frame_.axes[2] - numbers::interval_vec(stored.center));
  const Interval reach = radius_ + Interval(stored.radius);
  const Interval longest = Interval(1) + error_of_frame();
  return (norm(off) + reach_along_axes() * norm(across(along)) +
          Interval((radius - reach).magnitude()) * longest +
          radius * norm(axis) * norm(back - sign * own)) /
         reach;
}

std::optional<BallOnCylinders> BallOnCylinders::of(const CanalFillet& fillet) {
  constexpr double kShows = 0x1p-24;  // all others are proved by derivatives
  std::optional<BallOnCylinders> result;
  if (const auto* through = std::get_if<RollingThrough>(&fillet.motion)) {
    result = BallOnCylinders(*through);
  } else if (const auto* partly = std::get_if<RollingPartly>(&fillet.motion)) {
    result = BallOnCylinders(*partly);
  }
  const auto& [one, two] = fillet.quadrics;
  if (!result || one.slope != 0 || two.slope != 0 || !(result->frame_.sine.lower > 0) ||
      !(result->cylinders_[0].radius.lower > 0 && result->cylinders_[1].radius.lower > 0)) {
    return std::nullopt;
  }
  // Which of them is which is not stored.
  const auto error = [&](const Ring& first, const Ring& second) {
    return max(result->error_of_normal(0, first), result->error_of_normal(1, second)).upper;
  };
  result->error_ = (result->error_of_frame() + std::min(error(one, two), error(two, one))).upper;
  result->slack_ =
      (Interval(4) * result->radius_ * result->curvature_ * Interval(result->error_)).upper;
  return result->slack_ <= kShows && result->error_ <= kShows ? result : std::nullopt;
}

std::array<BallOnCylinders::Normal, 2> BallOnCylinders::normals(const Interval& cosine,
                                                                const Interval& sine) const {
  if (passes_) {
    const Interval up = scale_[0] * sine - shift_;
    return {Normal{up, beside(up, side_)}, Normal{sine, cosine}};
  }
  const Interval first = scale_[0] * square(sine) - Interval(1);
  const Interval second = Interval(1) - scale_[1] * square(cosine);
  return {Normal{first, beside(first, sine)}, Normal{second, beside(second, cosine)}};
}

// Let k_i be the radius times the curvatures along the normals n_i, which are at the angle t, and
// e = n1 x n2 / sin t the tangent. With c = cos t, an axis a_i and the other normal n_j,
// sin^2(e, a_i) = (n_j.a_i)^2 / sin^2 t. At alpha n1 + beta n2, a unit vector, 1 less the
// regularity is alpha k1 + beta k2: at most max(k1, k2) / cos(t/2); and at most
// k = sqrt(k1^2 + k2^2 - 2 k1 k2 c) / sin t, which it is between the normals if and only if
// c k1 < k2 and c k2 < k1; else it is most at one of them.
//
// Of the stored numbers. Let the frame A be off by e < 1/10: |A^T A - 1| <= e, the normals N_i off
// A n_i by f, and g = f / cos(t/2), e + g <= 1/10. With K the curvature of u and m = alpha n1 +
// beta n2, that of A u is K' = Q A K / |A T|^2, Q across A T: K'.A m is off K.m by less than
// 2.4 e |K|, and |K'| <= 1.2 |K|. The unit vector v along alpha N1 + beta N2 is off A m by
// e + 2 g at most, and turned across A T by less than (e + g) / 4 more: K'.v is off K.m by less
// than 4 (e + g) |K|.
Interval BallOnCylinders::least_regularity(const ParameterInterval& at) const {
  const auto [cosine, sine] =
      numbers::cosine_and_sine(Interval(at.from, numbers::next_above(at.to)));
  const auto [one, two] = normals(cosine, sine);
  const Interval aslant = frame_.cosine;
  const Interval c =
      intersection(one.up * two.up - aslant * (one.aside * two.aside), Interval(-1, 1));
  const Interval bisector = Interval(1) + c;  // twice the square of cos(t/2)
  const Interval spread = sqrt(Interval(2) / bisector);
  if (!(bisector.lower > 0 && error_ * spread.upper < 0x1p-4)) {
    return Interval::whole();
  }
  const Interval squared_sine = square(frame_.sine);
  const Interval across_first = squared_sine * square(two.aside);
  const Interval across_second = squared_sine * square(one.aside);
  const Interval along_first = square(one.aside * two.up + aslant * (one.up * two.aside));
  const Interval along_second = square(two.aside * one.up + aslant * (two.up * one.aside));
  const Interval first = radius_ / cylinders_[0].radius * share(across_first, along_first);
  const Interval second = radius_ / cylinders_[1].radius * share(across_second, along_second);
  Interval most = max(first, second);
  const Interval before = c * first - second, behind = c * second - first;
  if (before.lower <= 0 && behind.lower <= 0) {
    const Interval squared =
        intersection(intersection(across_first + along_first, across_second + along_second),
                     bisector * (Interval(1) - c));
    const Interval between =
        sqrt(square(first - second) / squared + Interval(2) * first * second / bisector);
    const bool certain = before.upper < 0 && behind.upper < 0;
    most = {certain ? std::max(most.lower, between.lower) : most.lower,
            std::min(between.upper, (most * spread).upper)};
  }
  const Interval off = Interval(slack_) * spread;
  return Interval(1) - most + Interval(-off.upper, off.upper);
}

}  // namespace dupin::canal
