#include "assembly/fillet_part.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "dupin/blends/canal_patch.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kSamples = 256;  // of a loop

const RingedSurface& straight_tube(const PartSurface& surface, const std::string& name) {
  const auto* chain = std::get_if<Chain>(&surface);
  const auto* tube = chain != nullptr && chain->pieces.size() == 1 && chain->wall == 0
                         ? std::get_if<RingedSurface>(&chain->pieces.front())
                         : nullptr;
  if (tube == nullptr || !std::holds_alternative<LineSpine>(tube->spine)) {
    throw Error(Errc::invalid_argument,
                "a fillet is between straight pipes or cones, which '" + name + "' is not");
  }
  return *tube;
}

struct Range {
  double least = std::numeric_limits<double>::infinity(), most = -least;

  void include(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

// How a loop lies on one of its pipes.
struct Course {
  Range height;         // along the axis, from the start
  bool winds = false;   // about the axis
};

enum class Place { within, beside, across };

class Pipe {
 public:
  Pipe(const RingedSurface& tube, const std::string& name)
      : tube_(tube), name_(name), axis_(tube.end.normal),
        length_((tube.end.center - tube.start.center).dot(axis_)) {}

  [[nodiscard]] const Ring& ring() const { return tube_.end; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] double length() const { return length_; }

  [[nodiscard]] double height(const Vec3& point) const {
    return (point - tube_.start.center).dot(axis_);
  }

  [[nodiscard]] Course course(const CanalFillet& loop, std::size_t side) const {
    Course course;
    double turn = 0;
    Vec3 last = arm(foot(loop, side, kSamples - 1));
    for (int i = 0; i < kSamples; ++i) {
      const Vec3 point = foot(loop, side, i), next = arm(point);
      course.height.include(height(point));
      turn += std::atan2(last.cross(next).dot(axis_), last.dot(next));
      last = next;
    }
    course.winds = std::abs(turn) > kTurn / 2;
    return course;
  }

  [[nodiscard]] Place place(const Course& course) const {
    if (course.height.least > 0 && course.height.most < length_) {
      return Place::within;
    }
    return course.height.most < 0 || course.height.least > length_ ? Place::beside : Place::across;
  }

  // Whether a disc lies inside, by distances of points on its circle and how far these may differ
  // from those of their neighbours.
  [[nodiscard]] bool buries(const Ring& disc) const {
    const Vec3 first = reference_axis(disc), second = disc.normal.cross(first);
    const double step = kTurn / kSamples, between = disc.radius * step / 2;
    for (int i = 0; i < kSamples; ++i) {
      const Vec3 point = disc.center + disc.radius * (std::cos(i * step) * first +
                                                      std::sin(i * step) * second);
      const double at = height(point), slack = between * (1 + std::abs(tube_.end.slope));
      const double radius = tube_.end.radius + tube_.end.slope * (at - length_);
      if (!(arm(point).norm() + slack < radius && at > between && at < length_ - between)) {
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] const Ring& end(End end) const {
    return end == End::start ? tube_.start : tube_.end;
  }

  // Where the axis is next to another one.
  [[nodiscard]] double height_next_to(const Pipe& other) const {
    const Vec3 between = other.tube_.start.center - tube_.start.center;
    const double cosine = axis_.dot(other.axis_);
    return (between.dot(axis_) - cosine * between.dot(other.axis_)) / (1 - cosine * cosine);
  }

 private:
  static Vec3 foot(const CanalFillet& loop, std::size_t side, int i) {
    return contact_arc(loop.quadrics, ball(loop, kTurn * i / kSamples)).feet.at(side);
  }
  [[nodiscard]] Vec3 arm(const Vec3& point) const {
    const Vec3 from = point - tube_.start.center;
    return from - from.dot(axis_) * axis_;
  }

  const RingedSurface& tube_;
  const std::string& name_;
  Vec3 axis_;
  double length_;
};

[[noreturn]] void refuse(const std::string& why) { throw Error(Errc::infeasible_blend, why); }

class Search {
 public:
  Search(const std::array<Pipe, 2>& pipes, double radius) : pipes_(pipes), radius_(radius) {}

  Fillet run() {
    for (CanalFillet& loop :
         rolling_ball_fillets({pipes_[0].ring(), pipes_[1].ring()}, radius_)) {
      consider(std::move(loop));
    }
    if (result_.loops.empty()) {
      refuse("'" + pipes_[0].name() + "' and '" + pipes_[1].name() +
             "' do not cross within their lengths");
    }
    for (std::size_t i = 0; i < 2; ++i) {
      bury(i);
    }
    return std::move(result_);
  }

 private:
  void consider(CanalFillet loop) {
    const std::array<Course, 2> courses{pipes_[0].course(loop, 0), pipes_[1].course(loop, 1)};
    const std::array<Place, 2> places{pipes_[0].place(courses[0]), pipes_[1].place(courses[1])};
    if (places[0] == Place::beside || places[1] == Place::beside) {
      return;
    }
    for (std::size_t i = 0; i < 2; ++i) {
      if (places.at(i) == Place::across) {
        const Range& height = courses.at(i).height;
        const double over = std::max(-height.least, height.most - pipes_.at(i).length());
        refuse("the fillet runs over the end of '" + pipes_.at(i).name() + "' by " +
               decimal(over, kMessageDigits));
      }
    }
    for (int i = 0; i < kSamples; ++i) {
      const MovingBall at = ball(loop, kTurn * i / kSamples);
      if (!(least_regularity(at, contact_arc(loop.quadrics, at)) > 0)) {
        refuse("the fillet folds: the ball is too large for the turns of its way");
      }
    }
    result_.loops.push_back(std::move(loop));
    courses_.push_back(courses);
  }

  // A pipe that a single loop winds about ends inside the other one, on the far side of the axes'
  // crossing.
  void bury(std::size_t i) {
    const bool winds = courses_.front().at(i).winds;
    if (!winds || result_.loops.size() > 1) {
      return;
    }
    const Range& height = courses_.front().at(i).height;
    const bool beyond =
        (height.least + height.most) / 2 > pipes_.at(i).height_next_to(pipes_.at(1 - i));
    const End end = beyond ? End::start : End::end;
    if (!pipes_.at(1 - i).buries(pipes_.at(i).end(end))) {
      refuse("the end '" + pipes_.at(i).name() + (beyond ? ".start" : ".end") +
             "' neither lies inside '" + pipes_.at(1 - i).name() +
             "' nor so far beyond it that a fillet fits there");
    }
    result_.buried.at(i).at(at(end)) = true;
  }

  const std::array<Pipe, 2>& pipes_;
  double radius_;
  Fillet result_;
  std::vector<std::array<Course, 2>> courses_;
};

std::optional<Fillet> feasible(const std::array<Pipe, 2>& pipes, double radius) {
  try {
    return Search(pipes, radius).run();
  } catch (const Error&) {
    return std::nullopt;
  }
}

// To two digits, rounded down; none if not even a thousandth of the ball fits.
std::optional<double> largest_radius_below(const std::array<Pipe, 2>& pipes, double radius) {
  double fits = radius / 1000, too_large = radius;
  if (!feasible(pipes, fits)) {
    return std::nullopt;
  }
  while (too_large > 1.005 * fits) {
    const double middle = std::sqrt(fits * too_large);
    (feasible(pipes, middle) ? fits : too_large) = middle;
  }
  const double digit = std::pow(10, std::floor(std::log10(fits)) - 1);
  return std::floor(fits / digit) * digit;
}

}  // namespace

Fillet fillet_between(const std::array<const PartSurface*, 2>& surfaces,
                      const std::array<std::string, 2>& names, double radius) {
  const std::array<Pipe, 2> pipes{Pipe(straight_tube(*surfaces[0], names[0]), names[0]),
                                  Pipe(straight_tube(*surfaces[1], names[1]), names[1])};
  try {
    return Search(pipes, radius).run();
  } catch (const Error& error) {
    const auto largest = largest_radius_below(pipes, radius);
    throw Error(Errc::infeasible_blend,
                error.message() + (largest ? "; the largest ball that fits has a radius of " +
                                                 decimal(*largest, 2)
                                           : std::string("; nor does a smaller ball fit")));
  }
}

}  // namespace dupin::assembly
