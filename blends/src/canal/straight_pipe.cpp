#include "canal/straight_pipe.h"

#include <cmath>
#include <numbers>

namespace dupin::canal {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kSamples = 256;  // of a disc

}  // namespace

const RingedSurface* straight_tube(const PartSurface& surface) {
  const auto* chain = std::get_if<Chain>(&surface);
  const auto* tube = chain != nullptr && chain->pieces.size() == 1 && chain->wall == 0
                         ? std::get_if<RingedSurface>(&chain->pieces.front())
                         : nullptr;
  return tube != nullptr && std::holds_alternative<LineSpine>(tube->spine) ? tube : nullptr;
}

bool is_within_run(const PartSurface& run, const Ring& disc) {
  const RingedSurface* tube = straight_tube(run);
  return tube != nullptr && StraightPipe(*tube, {}, 0).buries(disc);
}

StraightPipe::StraightPipe(const RingedSurface& tube, const std::string& name, double outward)
    : tube_(tube),
      name_(name),
      outward_(outward),
      axis_(tube.end.normal),
      length_((tube.end.center - tube.start.center).dot(axis_)) {}

// How often it goes about the axis: as often as it crosses a half-plane from it.
Course StraightPipe::course(std::span<const Vec3> points) const {
  Course course;
  Vec3 last = arm(points.back());
  const Vec3 up = axis_.cross(last);
  double last_height = height(points.back());
  bool was_up = last.dot(up) >= 0;
  int turns = 0;
  for (const Vec3& point : points) {
    const Vec3 next = arm(point);
    const double next_height = height(point);
    course.height.include(next_height);
    course.step = std::max(course.step, std::abs(next_height - last_height));
    const bool is_up = next.dot(up) >= 0;
    if (is_up != was_up && (last.cross(next).dot(axis_) > 0) == is_up) {
      turns += is_up ? 1 : -1;
    }
    last = next;
    last_height = next_height;
    was_up = is_up;
  }
  course.winds = turns != 0;
  return course;
}

Place StraightPipe::place(const Course& course, const std::array<bool, 2>& buried) const {
  const Range& height = course.height;
  const double middle = (height.least + height.most) / 2;
  const bool over_start = buried[0] ? middle > 0 : height.least > 0;
  const bool under_end = buried[1] ? middle < length_ : height.most < length_;
  if (over_start && under_end) {
    return Place::within;
  }
  const bool beside = (buried[0] && !over_start) || (buried[1] && !under_end) || height.most < 0 ||
                      height.least > length_;
  return beside ? Place::beside : Place::across;
}

double StraightPipe::reach_out(const Ring& disc) const {
  const Vec3 first = reference_axis(disc), second = disc.normal.cross(first);
  const auto over = [&](double t) {  // how far the circle's point is outside
    return outside(disc.center + disc.radius * (std::cos(t) * first + std::sin(t) * second));
  };
  double most = 0, step = kTurn / kSamples;
  for (int i = 1; i < kSamples; ++i) {
    most = over(i * step) > over(most) ? i * step : most;
  }
  for (; step > 1e-9; step /= 2) {
    most = over(most - step) > over(most) ? most - step : most;
    most = over(most + step) > over(most) ? most + step : most;
  }
  return over(most);
}

bool StraightPipe::buries(const Ring& disc) const {
  // No point of it is more than its radius away from its center, nor `outside` by more than that
  // times what it grows by: most discs are clear of a touch by far.
  const double center = outside(disc.center);
  const double most = disc.radius * std::hypot(1, tube_.end.slope);
  const double touch = kTouching * (tube_.end.radius + most + std::abs(center));
  if (std::abs(center) > most + 2 * touch) {
    return center < 0;
  }
  return reach_out(disc) <= kTouching * tube_.end.radius;
}

double StraightPipe::outside(const Vec3& point) const {
  const double at = height(point);
  const double radius = tube_.end.radius + tube_.end.slope * (at - length_);
  return std::max({arm(point).norm() - radius, -at, at - length_});
}

double StraightPipe::height(const Vec3& point) const {
  return (point - tube_.start.center).dot(axis_);
}

Vec3 StraightPipe::arm(const Vec3& point) const {
  const Vec3 from = point - tube_.start.center;
  return from - from.dot(axis_) * axis_;
}

}  // namespace dupin::canal
