#include "surfaces/moving_disc.h"

#include <algorithm>
#include <vector>

#include "numbers/bezier.h"
#include "numbers/quaternion.h"

namespace dupin::surfaces {
namespace {

// Bernstein coefficients of a polynomial that t divides, over t.
template <class T>
std::vector<T> over_t(const std::vector<T>& p) {
  std::vector<T> q;
  const auto degree = static_cast<double>(p.size() - 1);
  for (std::size_t i = 1; i < p.size(); ++i) {
    q.push_back(numbers::Interval(degree) / double(i) * p[i]);
  }
  return q;
}

// The derivative of a Bezier polynomial on t, over t or 1 - t if `start` or `end`, where it must
// vanish.
template <class T>
T rate(const std::vector<T>& points, const numbers::Interval& t, bool start, bool end) {
  std::vector<T> difference;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    difference.push_back(numbers::Interval(double(points.size() - 1)) *
                         (points[i + 1] - points[i]));
  }
  if (start) {
    difference = over_t(difference);
  } else if (end) {
    std::reverse(difference.begin(), difference.end());
    difference = over_t(difference);
    std::reverse(difference.begin(), difference.end());
  }
  return numbers::bezier_range(difference, t);
}

bool rests(const RationalRingedSurface& surface, End end) {
  const auto& [center, radius, rotation] = surface;
  return end == End::end
             ? center[3] == center[2] && rotation.back() == rotation[rotation.size() - 2]
             : center[0] == center[1] && rotation[0] == rotation[1];
}

numbers::IntervalVec axis_of(const numbers::Quaternion<numbers::Interval>& a,
                             const numbers::Quaternion<numbers::Interval>& b) {
  const numbers::Quaternion<numbers::Interval> unit{0, 1, 0, 0};
  const auto n = numbers::product(numbers::product(a, unit), numbers::conjugate(b));
  return {n[1], n[2], n[3]};
}

}  // namespace

std::optional<MovingDisc> moving_disc(const RationalRingedSurface& surface,
                                      const numbers::Interval& t, bool steered) {
  const bool start = steered && t.lower == 0 && rests(surface, End::start);
  const bool end = steered && t.upper == 1 && rests(surface, End::end);
  std::vector<numbers::IntervalVec> points;
  for (const Vec3& point : surface.center) {
    points.push_back(numbers::interval_vec(point));
  }
  numbers::Quaternion<numbers::Interval> a, a1;
  for (std::size_t part = 0; part < 4; ++part) {
    std::vector<numbers::Interval> numbers;
    for (const auto& control : surface.rotation) {
      numbers.emplace_back(control[part]);
    }
    a[part] = numbers::bezier_range(numbers, t);
    a1[part] = rate(numbers, t, start, end);
  }
  const numbers::IntervalVec n = axis_of(a, a), n1 = axis_of(a1, a) + axis_of(a, a1);
  const numbers::Interval length = numbers::norm(n);
  if (!(length.lower > 0)) {
    return std::nullopt;
  }
  const numbers::IntervalVec normal = numbers::Interval(1) / length * n;
  return MovingDisc{
      numbers::bezier_range(points, t), normal, rate(points, t, start, end),
      numbers::Interval(1) / length * (n1 - numbers::dot(normal, n1) * normal),
      numbers::bezier_range(
          std::vector<numbers::Interval>(surface.radius.begin(), surface.radius.end()), t)};
}

DiscPace pace(const MovingDisc& disc, double width) {
  return {numbers::dot(disc.velocity, disc.normal).lower,
          numbers::norm(numbers::cross(disc.velocity, disc.normal)).upper,
          numbers::norm(disc.turning).upper, disc.radius, width};
}

bool advances(const std::vector<DiscPace>& way) {
  numbers::Interval phi = 0, radius = 0;
  for (const DiscPace& stretch : way) {
    phi = phi + numbers::Interval(stretch.width) * stretch.turning;
    radius = {0, std::max(radius.upper, stretch.radius.upper)};
  }
  phi = phi.upper;
  radius = radius.upper;
  const numbers::Interval cosine = numbers::Interval(1) - square(phi) / 2;
  return phi.upper < 1 && std::all_of(way.begin(), way.end(), [&](const DiscPace& stretch) {
           return stretch.radius.lower > 0 &&
                  (stretch.advance * cosine - stretch.sideways * phi - radius * stretch.turning)
                          .lower > 0;
         });
}

}  // namespace dupin::surfaces
