#include "assembly/fillet_part.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/blends/canal_fillet.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kSamples = 256;  // of a loop
// What rounding leaves of a touch, of a radius.
constexpr double kTouching = 1e-9;
constexpr double kRounding = 1e-13;  // of what is no touch
// A smaller gap would have the ball turn within the rounding of where it is.
constexpr double kTouchingPipes = 0x1p-33;

const RingedSurface& straight_tube(const PartSurface& surface, const std::string& name) {
  const auto* chain = std::get_if<Chain>(&surface);
  const auto* tube = chain != nullptr && chain->pieces.size() == 1 && chain->wall == 0
                         ? std::get_if<RingedSurface>(&chain->pieces.front())
                         : nullptr;
  if (tube == nullptr || !std::holds_alternative<LineSpine>(tube->spine)) {
    throw Error(Errc::invalid_argument,
                "'" + name + "' is no straight pipe or cone of circular sections");
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
  Range height;        // along the axis, from the start
  bool winds = false;  // about the axis
};

enum class Place { within, beside, across };

class Pipe {
 public:
  Pipe(const RingedSurface& tube, const std::string& name)
      : tube_(tube),
        name_(name),
        axis_(tube.end.normal),
        length_((tube.end.center - tube.start.center).dot(axis_)) {}

  [[nodiscard]] const Ring& ring() const { return tube_.end; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] double length() const { return length_; }

  [[nodiscard]] double height(const Vec3& point) const {
    return (point - tube_.start.center).dot(axis_);
  }

  // Of points that a loop has on it, once around.
  [[nodiscard]] Course course(std::span<const Vec3> points) const {
    Course course;
    double turn = 0;
    Vec3 last = arm(points.back());
    for (const Vec3& point : points) {
      const Vec3 next = arm(point);
      course.height.include(height(point));
      turn += std::atan2(last.cross(next).dot(axis_), last.dot(next));
      last = next;
    }
    course.winds = std::abs(turn) > kTurn / 2;
    return course;
  }

  // Beyond a buried end there is no face: a loop is on this side of it, but for one point where the
  // pipes touch, or on the other.
  [[nodiscard]] Place place(const Course& course, const std::array<bool, 2>& buried) const {
    const Range& height = course.height;
    const double middle = (height.least + height.most) / 2;
    const bool over_start = buried[0] ? middle > 0 : height.least > 0;
    const bool under_end = buried[1] ? middle < length_ : height.most < length_;
    if (over_start && under_end) {
      return Place::within;
    }
    const bool beside = (buried[0] && !over_start) || (buried[1] && !under_end) ||
                        height.most < 0 || height.least > length_;
    return beside ? Place::beside : Place::across;
  }

  // How far a disc reaches out of it, negative inside.
  [[nodiscard]] double reach_out(const Ring& disc) const {
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

  // Whether a disc lies inside; it may touch, as the end of a branch as thick as the pipe does.
  [[nodiscard]] bool buries(const Ring& disc) const {
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

  [[nodiscard]] double outside(const Vec3& point) const {
    const double at = height(point);
    const double radius = tube_.end.radius + tube_.end.slope * (at - length_);
    return std::max({arm(point).norm() - radius, -at, at - length_});
  }

  [[nodiscard]] const Ring& end(End end) const {
    return end == End::start ? tube_.start : tube_.end;
  }

 private:
  [[nodiscard]] Vec3 arm(const Vec3& point) const {
    const Vec3 from = point - tube_.start.center;
    return from - from.dot(axis_) * axis_;
  }

  const RingedSurface& tube_;
  const std::string& name_;
  Vec3 axis_;
  double length_;
};

// Points that a loop has on both pipes.
std::array<std::vector<Vec3>, 2> sampled_feet(const CanalFillet& loop) {
  std::array<std::vector<Vec3>, 2> feet;
  for (int i = 0; i < kSamples; ++i) {
    const ContactArc arc = contact_arc(loop.quadrics, ball(loop, kTurn * i / kSamples));
    feet[0].push_back(arc.feet[0]);
    feet[1].push_back(arc.feet[1]);
  }
  return feet;
}

[[noreturn]] void refuse(const std::string& why) { throw Error(Errc::infeasible_blend, why); }

// With a radius of 0, of a cope.
class Search {
 public:
  static Fillet without_loops(const std::array<Pipe, 2>& pipes, double radius) {
    Fillet result;
    result.radius = radius;
    for (const std::size_t i : {0U, 1U}) {
      for (const End end : {End::start, End::end}) {
        result.buried.at(i).at(at(end)) = pipes.at(1 - i).buries(pipes.at(i).end(end));
      }
      if (result.buried.at(i)[0] && result.buried.at(i)[1]) {
        refuse("'" + pipes.at(i).name() + "' lies inside '" + pipes.at(1 - i).name() + "'");
      }
    }
    return result;
  }

  Search(const std::array<Pipe, 2>& pipes, double radius)
      : Search(pipes, without_loops(pipes, radius)) {}

  Search(const std::array<Pipe, 2>& pipes, Fillet without_loops)
      : pipes_(pipes), radius_(without_loops.radius), result_(std::move(without_loops)) {}

  Fillet run() {
    Fillet result = with_loops();
    if (radius_ > 0) {
      prove(result);
    }
    return result;
  }

  Fillet with_loops() {
    for (CanalFillet& loop : loops()) {
      consider(std::move(loop));
    }
    if (result_.loops.empty() && radius_ > 0 && cross()) {
      refuse("the ball is too large: its way is beyond the ends of '" + pipes_[0].name() +
             "' or '" + pipes_[1].name() + "'");
    }
    if (result_.loops.empty()) {
      refuse("'" + pipes_[0].name() + "' and '" + pipes_[1].name() +
             "' do not cross within their lengths" + half_buried_end());
    }
    for (const std::size_t i : {0U, 1U}) {
      refuse_open_end(i);
    }
    return std::move(result_);
  }

  void prove(Fillet& fillet) const {
    double regularity = 1;
    for (const CanalFillet& loop : fillet.loops) {
      const CanalRegularity proof = prove_regular(loop);
      if (proof.verdict != Verdict::proved) {
        refuse(proof.verdict == Verdict::refuted
                   ? "the fillet folds: the ball is too large for the turns of its way"
                   : "whether the fillet folds is undecided" + half_buried_end());
      }
      regularity = std::min(regularity, proof.regularity);
    }
    fillet.regularity = regularity;
  }

 private:
  // Round parallel axes the ball grows and shrinks. Of equally thick pipes the second passes
  // through the first: the one that ends there.
  [[nodiscard]] std::vector<CanalFillet> loops() const {
    const auto ends_inside = [&](std::size_t i) {
      return result_.buried.at(i)[0] || result_.buried.at(i)[1];
    };
    const bool parallel = pipes_[0].ring().normal.cross(pipes_[1].ring().normal).norm() < kTouching;
    const bool swaps = !parallel && ends_inside(0) && !ends_inside(1);
    const std::array<Ring, 2> quadrics{pipes_.at(swaps ? 1 : 0).ring(),
                                       pipes_.at(swaps ? 0 : 1).ring()};
    if (parallel && radius_ == 0) {
      refuse("the axes are parallel: such pipes are not cut along each other");
    }
    auto loops = parallel ? rational_fillets(quadrics, radius_)
                          : rolling_ball_fillets(quadrics, radius_, kTouchingPipes);
    for (CanalFillet& loop : loops) {
      loop.quadrics = {pipes_[0].ring(), pipes_[1].ring()};
    }
    return loops;
  }

  // Whether the sharp edge is within the pipes' lengths.
  [[nodiscard]] bool cross() const {
    try {
      return !Search(pipes_, 0).run().loops.empty();
    } catch (const Error&) {
      return false;
    }
  }

  // With which radius a disc would lie inside the other pipe where it is. As much of it does as
  // the smaller it is.
  [[nodiscard]] std::string radius_inside(std::size_t i, Ring disc) const {
    double inside = 0, out = disc.radius;
    for (int step = 0; step < 50; ++step) {
      disc.radius = (inside + out) / 2;
      (pipes_.at(1 - i).reach_out(disc) > 0 ? out : inside) = disc.radius;
    }
    return inside > 0
               ? "; there it lies inside with a radius of " + decimal_at_least(inside) + " at most"
               : std::string();
  }

  // Where no end of it would lie inside the other one, wherever it ends.
  [[nodiscard]] std::string no_room_beside_axis(std::size_t i) const {
    const Ring &own = pipes_.at(i).ring(), &other = pipes_.at(1 - i).ring();
    const Vec3 across = own.normal.cross(other.normal);
    const double aside = std::abs((other.center - own.center).dot(across.normalized()));
    constexpr int kDigits = 12;  // that it is less shows
    const double room = other.radius - aside;
    if (own.slope != 0 || other.slope != 0 || across.norm() < kTouching ||
        own.radius <= room + kTouching * other.radius) {
      return {};
    }
    const std::string &name = pipes_.at(i).name(), &around = pipes_.at(1 - i).name();
    const std::string off = "; its axis is " + decimal(aside, kMessageDigits) + " off that of '" +
                            around + "', where nothing thicker than a radius of ";
    return (room > 0 ? off + decimal(room, kDigits) + " ends in it" : "; it is too far aside") +
           ": '" + name + "' may go on through '" + around + "'";
  }

  // What may be meant to lie inside the other pipe, and does so but for a part.
  [[nodiscard]] std::string half_buried_end() const {
    for (const std::size_t i : {0U, 1U}) {
      for (const End end : {End::start, End::end}) {
        const Ring& disc = pipes_.at(i).end(end);
        const double out = pipes_.at(1 - i).reach_out(disc);
        if (out > kRounding * disc.radius && pipes_.at(1 - i).outside(disc.center) < 0) {
          return ": '" + to_string({pipes_.at(i).name(), end}) + "' lies inside '" +
                 pipes_.at(1 - i).name() + "' only in part, and sticks out by " +
                 decimal(out, kMessageDigits) + radius_inside(i, disc) + no_room_beside_axis(i);
        }
      }
    }
    return {};
  }

  void consider(CanalFillet loop) {
    const auto feet = sampled_feet(loop);
    const std::array<Course, 2> courses{pipes_[0].course(feet[0]), pipes_[1].course(feet[1])};
    const std::array<Place, 2> places{pipes_[0].place(courses[0], result_.buried[0]),
                                      pipes_[1].place(courses[1], result_.buried[1])};
    if (places[0] == Place::beside || places[1] == Place::beside) {
      return;
    }
    for (std::size_t i = 0; i < 2; ++i) {
      if (places.at(i) == Place::across) {
        const Range& height = courses.at(i).height;
        const double over = std::max(-height.least, height.most - pipes_.at(i).length());
        refuse(std::string(radius_ == 0 ? "the cut" : "the fillet") + " runs over the end of '" +
               pipes_.at(i).name() + "' by " + decimal(over, kMessageDigits) + half_buried_end());
      }
    }
    result_.loops.push_back(std::move(loop));
    courses_.push_back(courses);
  }

  // A pipe that a single loop winds about has to end inside the other one.
  void refuse_open_end(std::size_t i) const {
    const auto& buried = result_.buried.at(i);
    if (courses_.front().at(i).winds && result_.loops.size() == 1 && !buried[0] && !buried[1]) {
      refuse("'" + pipes_.at(i).name() + "' neither ends inside '" + pipes_.at(1 - i).name() +
             "' nor passes so far through it that it is left on both sides");
    }
  }

  const std::array<Pipe, 2>& pipes_;
  double radius_;
  Fillet result_;
  std::vector<std::array<Course, 2>> courses_;
};

std::optional<std::string> fault_of(const std::array<Pipe, 2>& pipes, double radius) {
  try {
    (void)Search(pipes, radius).run();
    return std::nullopt;
  } catch (const Error& error) {
    return error.message();
  }
}

std::array<Pipe, 2> pipes_of(const std::array<const PartSurface*, 2>& surfaces,
                             const std::array<std::string, 2>& names) {
  return {Pipe(straight_tube(*surfaces[0], names[0]), names[0]),
          Pipe(straight_tube(*surfaces[1], names[1]), names[1])};
}

// The decimal of fewest digits that fits.
double shortest_between(double low, double high, const std::function<bool(double)>& fits) {
  for (int digits = 2; digits < 6; ++digits) {
    const double unit = std::pow(10, std::floor(std::log10(high)) + 1 - digits);
    const double tried = rounded(std::floor(high / unit) * unit, digits);
    if (tried > low && tried <= high && fits(tried)) {
      return tried;
    }
  }
  return high;
}

std::string what_would_do(const std::array<Pipe, 2>& pipes, double radius,
                          const std::function<bool(double)>& fits_bore) {
  const auto fits = [&](double tried) { return !fault_of(pipes, tried); };
  // No ball as large as both are long goes round.
  const double most = std::min(radius, pipes[0].length() + pipes[1].length());
  const auto outside = largest_radius_below(most, fits);
  if (!outside) {
    return "; nor does a smaller ball fit";
  }
  const std::string named = "; the largest ball that fits has a radius of ";
  if (!fits_bore || fits_bore(*outside)) {
    return named + decimal(*outside);
  }
  const auto both =
      largest_radius_below(*outside, [&](double tried) { return fits(tried) && fits_bore(tried); });
  return both ? named + decimal(*both)
              : named + decimal(*outside) +
                    ", but with these walls neither it nor a smaller one fits inside";
}

// What `work` does with the pipes; where it refuses them, with what would do.
template <typename Work>
auto searched(const std::array<const PartSurface*, 2>& surfaces,
              const std::array<std::string, 2>& names, double radius,
              const std::function<bool(double)>& fits_bore, const Work& work) {
  const std::array<Pipe, 2> pipes = pipes_of(surfaces, names);
  try {
    return work(pipes);
  } catch (const Error& error) {
    throw Error(Errc::infeasible_blend, error.message() + what_would_do(pipes, radius, fits_bore));
  }
}

}  // namespace

std::optional<double> largest_radius_below(double radius, const std::function<bool(double)>& fits) {
  constexpr double kMore = 1.01, kNear = 1.002;
  constexpr std::array<double, 4> kShares{1e-3, 1e-2, 1e-1, 0.5};
  constexpr int kMostGaps = 4;
  const auto* share =
      std::ranges::find_if(kShares, [&](double tried) { return fits(radius * tried); });
  if (share == kShares.end()) {
    return std::nullopt;
  }
  double named = 0;
  double feasible = radius * *share;
  for (int gap = 0; gap < kMostGaps; ++gap) {
    double too_large = radius;
    while (too_large > kNear * feasible) {
      const double middle = std::sqrt(feasible * too_large);
      (fits(middle) ? feasible : too_large) = middle;
    }
    named = shortest_between(too_large / kMore, feasible, fits);
    // What fits need not be all that is smaller.
    if (!(kMore * named < radius) || !fits(kMore * named)) {
      break;
    }
    feasible = kMore * named;
  }
  return named;
}

Fillet fillet_between(const std::array<const PartSurface*, 2>& surfaces,
                      const std::array<std::string, 2>& names, double radius,
                      const std::function<bool(double)>& fits_bore) {
  return searched(surfaces, names, radius, fits_bore,
                  [&](const auto& pipes) { return Search(pipes, radius).run(); });
}

Fillet fillet_without_loops(const std::array<const PartSurface*, 2>& surfaces,
                            const std::array<std::string, 2>& names, double radius,
                            const std::function<bool(double)>& fits_bore) {
  return searched(surfaces, names, radius, fits_bore,
                  [&](const auto& pipes) { return Search::without_loops(pipes, radius); });
}

void find_loops(Fillet& fillet, const std::array<const PartSurface*, 2>& surfaces,
                const std::array<std::string, 2>& names,
                const std::function<bool(double)>& fits_bore) {
  fillet = searched(surfaces, names, fillet.radius, fits_bore,
                    [&](const auto& pipes) { return Search(pipes, fillet).with_loops(); });
}

void prove(Fillet& fillet, const std::array<const PartSurface*, 2>& surfaces,
           const std::array<std::string, 2>& names, const std::function<bool(double)>& fits_bore) {
  searched(surfaces, names, fillet.radius, fits_bore,
           [&](const auto& pipes) { Search(pipes, fillet).prove(fillet); });
}

std::optional<std::string> fillet_fault(const std::array<const PartSurface*, 2>& surfaces,
                                        const std::array<std::string, 2>& names, double radius) {
  return fault_of(pipes_of(surfaces, names), radius);
}

Fillet cope_between(const std::array<const PartSurface*, 2>& surfaces,
                    const std::array<std::string, 2>& names) {
  const std::array<Pipe, 2> pipes = pipes_of(surfaces, names);
  try {
    return Search(pipes, 0).run();
  } catch (const Error& error) {
    throw Error(Errc::infeasible_blend, error.message());
  }
}

}  // namespace dupin::assembly
