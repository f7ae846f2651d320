#pragma once

#include <cstdint>
#include <optional>

#include "dupin/blends/canal_fillet.h"
#include "verification/motions/jet.h"
#include "verification/motions/taylor_jet.h"

namespace dupin::verification {

using numbers::interval_vec;

/// A stretch of a loop of balls. A loop has the parameters t in [0, 2]: the angle is
/// chi = 2 psi - pi/2, and between the whole numbers i and i + 1, psi is i pi/2 and the angle whose
/// tangent is (t - i) / (i + 1 - t). So nothing here is transcendental, and what may be a corner,
/// at sin chi = 1 or -1, is at t = 1 or 0. The middle is std::midpoint of both parameters.
struct TurnStretch : AngleStretch {
  Interval half_cosine, half_sine;  ///< of psi: sin chi = 1 - 2 cos^2 psi = 2 sin^2 psi - 1
  double half_cosine_sign = 1;      ///< half_sine is never negative
  double length = 0;                ///< an upper bound of how much chi grows
};

/// None unless it lies between two whole numbers.
[[nodiscard]] std::optional<TurnStretch> turn_stretch(const ParameterInterval& t);

/// Whether generators of cones lead the ball, which takes far more than those of cylinders.
[[nodiscard]] bool rolls_on_cones(const CanalFillet& loop);
/// In units of work, long jets of balls on cones.
constexpr std::uint64_t kConeWork = 512;

/// Of the quadratic equation that says where the generator of the second cone at the angle chi
/// meets the first one, the fourth part of the discriminant.
[[nodiscard]] AngleWave discriminant(const RollingOnCones& motion);

/// Derivatives are those by chi.
template <std::size_t count>
struct BallJets {
  JetVec<count> center;
  Jet<count> radius;
};

/// The formulas of the mathematics B.5 to B.7, with the stored numbers.
template <std::size_t count>
class BallReader {
 public:
  explicit BallReader(const TurnStretch& t)
      : turn_(t),
        half_cosine_sign_(t.half_cosine_sign),
        cosine_(waves(t.cosine, -t.sine, 1)),
        sine_(waves(t.sine, t.cosine, 1)),
        half_cosine_(waves(t.half_cosine, -t.half_sine, 0.5)),
        half_sine_(waves(t.half_sine, t.half_cosine, 0.5)) {}

  BallJets<count> operator()(const RollingThrough& motion) const {
    const double d = motion.distance;
    const J z = d * sine_ - fixed(motion.height);
    const J y = motion.side * (root(motion.below, d, half_cosine_, half_cosine_sign_) *
                               root(motion.above, d, half_sine_, 1));
    const J x = Interval(1) / motion.sine * (d * cosine_ + motion.cosine * y);
    return placed(motion, {x, y, z});
  }

  BallJets<count> operator()(const RollingPartly& motion) const {
    const Interval root_of_overlap = sqrt(Interval(motion.overlap));
    const J c2 = square(cosine_), s2 = square(sine_);
    const J z = motion.overlap * s2 - fixed(motion.distance);
    const J y =
        root_of_overlap * (sine_ * verification::sqrt(fixed(motion.first) + motion.overlap * c2));
    const J lower = root_of_overlap *
                    (cosine_ * verification::sqrt(fixed(motion.second) + motion.overlap * s2));
    return placed(motion, {Interval(1) / motion.sine * (lower + motion.cosine * y), y, z});
  }

  // Where the generator a + h b of the second quadric, h being its height over the ring, meets the
  // first one: |w|^2 - (w.n)^2 = (r + q w.n)^2 with w = a + h b. Of that quadratic equation,
  // quadratic h^2 + 2 half h + rest = 0.
  BallJets<count> operator()(const RollingOnCones& motion) const {
    const Ring &one = motion.first, &two = motion.second;
    const JetVec<count> around =
        cosine_ * interval_vec(motion.zero) + sine_ * interval_vec(motion.quarter);
    const JetVec<count> a =
        fixed(interval_vec(two.center) - interval_vec(one.center)) + two.radius * around;
    const JetVec<count> b = fixed(two.normal) + two.slope * around;
    const IntervalVec n = interval_vec(one.normal);
    const J an = dot(a, n), bn = dot(b, n), r = fixed(one.radius), q = fixed(one.slope);
    const J e1 = q * bn, quadratic = squared_norm(b) - square(bn) - square(e1);
    const J half = dot(a, b) - an * bn - (r + q * an) * e1;
    const J squared = wave_jet<count>(discriminant(motion), turn_);  // half^2 - quadratic * rest
    const J h = (motion.side * verification::sqrt(squared) - half) / quadratic;
    return {fixed(one.center) + a + h * b, fixed(motion.radius)};
  }

  // The same with the generators at q = tan(angle / 2) = width cos, times 1 + q^2, and with the
  // root of the discriminant divided by 1 - cos^2: the stored polynomial.
  BallJets<count> operator()(const RollingPartlyOnCones& motion) const {
    const Ring &one = motion.first, &two = motion.second;
    const J q = motion.width * cosine_, q2 = square(q), all = fixed(1) + q2;
    const JetVec<count> around =
        (fixed(1) - q2) * interval_vec(motion.zero) + (2.0 * q) * interval_vec(motion.quarter);
    const JetVec<count> a =
        all * (interval_vec(two.center) - interval_vec(one.center)) + two.radius * around;
    const JetVec<count> b = all * interval_vec(two.normal) + two.slope * around;
    const IntervalVec n = interval_vec(one.normal);
    const J an = dot(a, n), bn = dot(b, n), r = one.radius * all, k = fixed(one.slope);
    const J e0 = r + k * an, e1 = k * bn;
    const J quadratic = squared_norm(b) - square(bn) - square(e1);
    const J half = dot(a, b) - an * bn - e0 * e1;
    J rest = fixed(0);
    for (auto coefficient = motion.rest.rbegin(); coefficient != motion.rest.rend();
         ++coefficient) {
      rest = rest * cosine_ + fixed(*coefficient);
    }
    const J h = (sine_ * verification::sqrt(rest) - half) / quadratic;
    return {fixed(one.center) + (a + h * b) / all, fixed(motion.radius)};
  }

  BallJets<count> operator()(const RationalCrossing& motion) const {
    const double d = motion.distance;
    const std::array<double, 4>& g = motion.size;
    const J size =
        fixed(g[0]) + g[1] * cosine_ + g[2] * sine_ + g[3] * (square(cosine_) - square(sine_));
    const J p = size * sine_, p2 = square(p), n = fixed(1) + p2 - 2.0 * size;
    const J y = (motion.side * d) * ((fixed(1) - p2) / n);
    const J x = ((2 * d) * (size * cosine_ / n) + motion.cosine * y) / fixed(motion.sine);
    return combined(motion.origin, std::array{motion.along, motion.across, motion.e3, motion.e4},
                    {x, y, (2 * d) * (p / n), -d * ((fixed(1) + p2) / n)});
  }

  BallJets<count> operator()(const RationalParallel& motion) const {
    const double h = motion.half_distance;
    const Interval k = motion.product, rest = Interval(1) - numbers::square(k);
    const J a = (motion.far_squared / 2) * (fixed(1) + cosine_);
    const J b = (motion.near_squared / 2) * (fixed(1) - cosine_);
    const J c =
        sqrt(Interval(motion.far_squared)) * (sqrt(Interval(motion.near_squared)) * (0.5 * sine_));
    const J u = (fixed(1) + a) / (fixed(1) - a), v = (fixed(1) - b) / (fixed(1) + b);
    const J first = -h * (u - v), second = -h * (u + v);
    return combined(
        motion.origin, std::array{motion.ey, motion.ez, motion.nu1, motion.nu2},
        {h * (u * v), (4 * h) * (c / ((fixed(1) - a) * (fixed(1) + b))),
         Interval(1) / rest * (first + k * second), Interval(1) / rest * (second + k * first)});
  }

 private:
  using J = Jet<count>;

  static J fixed(const Interval& value) { return constant<count>(value); }
  static JetVec<count> fixed(const IntervalVec& v) {
    return {fixed(v[0]), fixed(v[1]), fixed(v[2])};
  }
  static JetVec<count> fixed(const Vec3& v) { return fixed(interval_vec(v)); }

  // f and f' of a wave of this frequency: f'' = -frequency^2 f.
  static J waves(const Interval& value, const Interval& next, double frequency) {
    J result;
    double factor = 1;
    for (std::size_t k = 0; k < count; ++k, factor *= frequency) {
      result[k] = Interval(k % 4 < 2 ? factor : -factor) * (k % 2 == 0 ? value : next);
    }
    return result;
  }

  // sqrt(gap + 2 d x^2), where x does not change its sign.
  static J root(double gap, double d, const J& x, double sign) {
    return gap == 0 ? (sign * sqrt(Interval(2) * d)) * x
                    : verification::sqrt(fixed(gap) + 2.0 * (d * square(x)));
  }

  template <class Motion>
  static BallJets<count> placed(const Motion& motion, const JetVec<count>& at) {
    return {fixed(motion.origin) + at[0] * interval_vec(motion.along) +
                at[1] * interval_vec(motion.across) + at[2] * interval_vec(motion.up),
            fixed(motion.radius)};
  }

  // Points of R^{3,1}, whose last coordinate is minus the radius.
  static BallJets<count> combined(const PeVector& origin, const std::array<PeVector, 4>& axes,
                                  const std::array<J, 4>& at) {
    BallJets<count> result{fixed(origin.m), fixed(-origin.r)};
    for (std::size_t i = 0; i < 4; ++i) {
      result.center = result.center + at[i] * interval_vec(axes[i].m);
      result.radius = result.radius - axes[i].r * at[i];
    }
    return result;
  }

  TurnStretch turn_;
  double half_cosine_sign_;
  J cosine_, sine_, half_cosine_, half_sine_;
};

}  // namespace dupin::verification
