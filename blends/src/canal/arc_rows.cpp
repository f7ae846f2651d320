#include "canal/arc_rows.h"

#include "canal/rational_fillet.h"
#include "canal/rolling_ball.h"
#include "canal/stretch.h"
#include "dupin/blends/pe_arc.h"

namespace dupin::canal {
namespace {

using Long = Series<kArcOrders + 1>;  // of which derivatives are taken
template <class T>
using Vec = std::array<T, 3>;

template <class T>
T dot(const Vec<T>& a, const Vec<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class T>
Vec<T> operator+(const Vec<T>& a, const Vec<T>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

template <class T>
Vec<T> operator-(const Vec<T>& a, const Vec<T>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class T>
Vec<T> operator*(const T& s, const Vec<T>& a) {
  return {s * a[0], s * a[1], s * a[2]};
}

Vec<ArcSeries> fixed(const Vec3& v) { return {ArcSeries(v[0]), ArcSeries(v[1]), ArcSeries(v[2])}; }

// Jets of series, of which only the values mean anything: these have all derivatives in them.
Turn<Long> turn_of_series(const ParameterInterval& at, const ParameterInterval& stretch) {
  const Turn<numbers::Interval> over = turn(at);
  const auto beside = turn((stretch.from + stretch.to) / 2);
  const auto &c = over.cosine.value, &s = over.sine.value, &p = over.half_cosine.value,
             &q = over.half_sine.value;
  const auto jet = [](const Long& value) { return Jet<Long>(value, Long(0.0), Long(0.0)); };
  constexpr std::size_t n = kArcOrders + 1;
  return {jet(wave<n>(c, -s, 1)),  jet(wave<n>(s, c, 1)),   jet(wave<n>(p, -q, 0.5)),
          jet(wave<n>(q, p, 0.5)), beside.half_cosine_sign, beside.half_sine_sign};
}

// The outward normal where the ball touches the quadric from outside.
Vec<ArcSeries> normal(const Ring& quadric, const Vec<ArcSeries>& center, const ArcSeries& radius) {
  const PeVector sphere = contact_sphere(quadric), along = contact_tangent(quadric);
  const Vec<ArcSeries> axis = fixed(along.m), to_ball = center - fixed(sphere.m);
  const ArcSeries reach = radius + ArcSeries(sphere.r);
  const ArcSeries shift = dot(to_ball, axis) + reach * ArcSeries(along.r);
  return (ArcSeries(1.0) / (reach + shift * ArcSeries(along.r))) * (to_ball - shift * axis);
}

}  // namespace

ArcRows arc_rows(const CanalFillet& loop, const ParameterInterval& at,
                 const ParameterInterval& stretch) {
  const Turn<Long> over = turn_of_series(at, stretch);
  const BallJet<Long> ball =
      std::visit([&](const auto& motion) { return ball_jet<Long>(motion, over); }, loop.motion);
  Vec<ArcSeries> center, velocity;
  for (std::size_t k = 0; k < 3; ++k) {
    center[k] = shortened(ball.center[k].value);
    velocity[k] = derivative(ball.center[k].value);
  }
  const ArcSeries radius = shortened(ball.radius.value), growth = derivative(ball.radius.value);
  const ArcSeries squared = dot(velocity, velocity);
  // Of the circle in which the ball touches its envelope.
  const Vec<ArcSeries> middle = center - (radius * growth / squared) * velocity;
  const ArcSeries reach = radius * sqrt((squared - square(growth)) / squared);
  Vec<Vec<ArcSeries>> toward;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec<ArcSeries> to_foot =
        center - radius * normal(loop.quadrics.at(i), center, radius) - middle;
    const Vec<ArcSeries> across = to_foot - (dot(to_foot, velocity) / squared) * velocity;
    toward.at(i) = (ArcSeries(1.0) / sqrt(dot(across, across))) * across;
  }
  const Vec<ArcSeries> sum = toward[0] + toward[1];
  ArcRows rows;
  rows.weight = ArcSeries(0.5) * sqrt(dot(sum, sum));
  rows.points[0] = middle + reach * toward[0];
  rows.points[1] = rows.weight * middle + (ArcSeries(0.5) * reach / rows.weight) * sum;
  rows.points[2] = middle + reach * toward[1];
  return rows;
}

}  // namespace dupin::canal
