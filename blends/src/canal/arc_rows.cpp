#include "canal/arc_rows.h"

#include <algorithm>

#include "canal/stretch.h"
#include "dupin/blends/pe_arc.h"

namespace dupin::canal {
namespace {

// Coefficients beyond those that are asked for, with which these are enclosed over a stretch.
constexpr std::size_t kOrders = kArcOrders + 4;
using Rows = CenteredSeries<kOrders>;
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

Vec<Rows> fixed(const Vec3& v) { return {Rows(v[0]), Rows(v[1]), Rows(v[2])}; }

// The outward normal where the ball touches the quadric from outside.
Vec<Rows> normal(const Ring& quadric, const Vec<Rows>& center, const Rows& radius) {
  const PeVector sphere = contact_sphere(quadric), along = contact_tangent(quadric);
  const Vec<Rows> axis = fixed(along.m), to_ball = center - fixed(sphere.m);
  const Rows reach = radius + Rows(sphere.r);
  const Rows shift = dot(to_ball, axis) + reach * Rows(along.r);
  return (Rows(1.0) / (reach + shift * Rows(along.r))) * (to_ball - shift * axis);
}

struct RowSeries {
  std::array<Vec<Rows>, 3> points;
  Rows weight;
};

RowSeries rows_of(const CanalFillet& loop, const BallJet<CenteredSeries<kOrders + 1>>& ball) {
  Vec<Rows> center, velocity;
  for (std::size_t k = 0; k < 3; ++k) {
    center[k] = shortened(ball.center[k]);
    velocity[k] = derivative(ball.center[k]);
  }
  const Rows radius = shortened(ball.radius), growth = derivative(ball.radius);
  const Rows squared = dot(velocity, velocity);
  // Of the circle in which the ball touches its envelope.
  const Rows behind = radius * growth / squared;
  const Vec<Rows> middle = center - behind * velocity;
  const Rows reach = radius * square_root((squared - square(growth)) / squared);
  Vec<Vec<Rows>> toward;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec<Rows> to_foot =
        behind * velocity - radius * normal(loop.quadrics.at(i), center, radius);
    const Vec<Rows> across = to_foot - (dot(to_foot, velocity) / squared) * velocity;
    toward.at(i) = (Rows(1.0) / square_root(dot(across, across))) * across;
  }
  const Vec<Rows> sum = toward[0] + toward[1];
  RowSeries rows;
  rows.weight = 0.5 * square_root(dot(sum, sum));
  rows.points[0] = middle + reach * toward[0];
  rows.points[1] = rows.weight * middle + (0.5 * reach / rows.weight) * sum;
  rows.points[2] = middle + reach * toward[1];
  return rows;
}

}  // namespace

ArcRows arc_rows(const CanalFillet& loop, const ParameterInterval& at,
                 const ParameterInterval& stretch) {
  const RowSeries series = rows_of(loop, ball_series<kOrders + 1>(loop, at, stretch));
  const auto asked = [](const Rows& all) {
    ArcSeries result;
    std::copy_n(all.all.at.begin(), kArcOrders, result.at.begin());
    return result;
  };
  ArcRows rows;
  rows.weight = asked(series.weight);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      rows.points.at(i).at(k) = asked(series.points.at(i).at(k));
    }
  }
  return rows;
}

}  // namespace dupin::canal
