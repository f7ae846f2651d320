#include "assembly/fillet_part.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "assembly/bore.h"
#include "assembly/narrowed_shape.h"
#include "canal/contact_feet.h"
#include "canal/straight_pipe.h"
#include "dupin/blends/canal_fillet.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {
namespace {

// Of a loop: few tell most.
constexpr int kFewSamples = 64, kSamples = 256;
constexpr double kTouching = canal::kTouching;
constexpr double kRounding = 1e-13;  // of what is no touch
// A smaller gap would have the ball turn within the rounding of where it is.
constexpr double kTouchingPipes = 0x1p-33;

using canal::Course;
using canal::Place;
using canal::Range;
using Pipe = canal::StraightPipe;

const RingedSurface& straight_tube(const PartSurface& surface, const std::string& name) {
  const RingedSurface* tube = canal::straight_tube(surface);
  if (tube == nullptr) {
    throw Error(Errc::invalid_argument,
                "'" + name + "' is no straight pipe or cone of circular sections");
  }
  return *tube;
}

// By points that a loop has on both pipes.
std::array<Course, 2> courses_of(const CanalFillet& loop, const std::array<Pipe, 2>& pipes,
                                 int samples) {
  const auto feet = canal::sampled_feet(loop, samples);
  return {pipes[0].course(feet[0]), pipes[1].course(feet[1])};
}

[[noreturn]] void refuse(const std::string& why) { throw Error(Errc::infeasible_blend, why); }

// What pipes are too short by, at both ends.
using Missing = std::array<std::array<double, 2>, 2>;

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

  // Of the loop that was refused for that, or the one that lacks least; none where all is well, or
  // something else is wrong.
  std::optional<Missing> missing() {
    try {
      (void)with_loops();
    } catch (const Error&) {
      return missing_ ? std::optional(missing_->second) : std::nullopt;
    }
    return std::nullopt;
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
    const double said = pipes_.at(i).said(inside);
    return inside > 0 && said > 0
               ? "; there it lies inside with a radius of " + decimal_at_least(said) + " at most"
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
    const double said = pipes_.at(i).said(room);
    if (own.radius > other.radius) {
      return "; it is thicker than '" + around + "', which may end in it or go on through it";
    }
    const std::string off = "; its axis is " + decimal(aside, kMessageDigits) + " off that of '" +
                            around + "', where nothing thicker than a radius of ";
    return (room > 0 && said > 0 ? off + decimal(said, kDigits) + " ends in it"
                                 : "; it is too far aside") +
           ": '" + name + "' may go on through '" + around + "'";
  }

  // What may be meant to lie inside the other pipe, and does so but for a part; none where the
  // other one ends in it.
  [[nodiscard]] std::string half_buried_end() const {
    for (const std::size_t i : {0U, 1U}) {
      if (result_.buried.at(1 - i)[0] || result_.buried.at(1 - i)[1]) {
        continue;
      }
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

  [[nodiscard]] std::array<Place, 2> places_of(const std::array<Course, 2>& courses) const {
    return {pipes_[0].place(courses[0], result_.buried[0]),
            pipes_[1].place(courses[1], result_.buried[1])};
  }

  void consider(CanalFillet loop) {
    constexpr std::array<Place, 2> kWithin{Place::within, Place::within};
    std::array<Course, 2> courses = courses_of(loop, pipes_, kFewSamples);
    const std::array<Course, 2> wide{courses[0].widened(), courses[1].widened()};
    if (pipes_[0].is_beyond_buried_end(wide[0], result_.buried[0]) ||
        pipes_[1].is_beyond_buried_end(wide[1], result_.buried[1])) {
      return;
    }
    std::array<Place, 2> places = places_of(wide);
    if (places != kWithin) {
      courses = courses_of(loop, pipes_, kSamples);
      places = places_of(courses);
    }
    if (places != kWithin) {
      note_missing(courses);
    }
    if (places[0] == Place::beside || places[1] == Place::beside) {
      return;
    }
    for (std::size_t i = 0; i < 2; ++i) {
      if (places.at(i) == Place::across) {
        const Range& height = courses.at(i).height;
        const double over = std::max(-height.least, height.most - pipes_.at(i).length());
        refuse(std::string(radius_ == 0 ? "the cut" : "the fillet") +
               (over > 0 ? " runs over the end of '" : " touches the end of '") +
               pipes_.at(i).name() + "'" +
               (over > 0 ? " by " + decimal(over, kMessageDigits) : "") + half_buried_end());
      }
    }
    result_.loops.push_back(std::move(loop));
    courses_.push_back(courses);
  }

  void note_missing(const std::array<Course, 2>& courses) {
    Missing missing{};
    double sum = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const Range& height = courses.at(i).height;
      const double length = pipes_.at(i).length(), middle = (height.least + height.most) / 2;
      const auto& buried = result_.buried.at(i);
      if ((buried[0] && middle <= 0) || (buried[1] && middle >= length)) {
        return;  // beyond an end that is inside
      }
      missing.at(i) = {buried[0] ? 0 : std::max(-height.least, 0.0),
                       buried[1] ? 0 : std::max(height.most - length, 0.0)};
      sum += missing.at(i)[0] + missing.at(i)[1];
    }
    if (sum > 0 && (!missing_ || sum < missing_->first)) {
      missing_ = std::pair(sum, missing);
    }
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
  // In all, and of each.
  std::optional<std::pair<double, Missing>> missing_;
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
                             const std::array<std::string, 2>& names, const PipeWalls& walls) {
  return {Pipe(straight_tube(*surfaces[0], names[0]), names[0], walls.outward[0]),
          Pipe(straight_tube(*surfaces[1], names[1]), names[1], walls.outward[1])};
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

// Made longer, along a cone if it is one; none where that would close.
std::optional<RingedSurface> lengthened(RingedSurface tube, const std::array<double, 2>& by) {
  for (const End end : {End::start, End::end}) {
    Ring& ring = end == End::start ? tube.start : tube.end;
    ring.center += by.at(at(end)) * ring.normal;
    ring.radius += by.at(at(end)) * ring.slope;
    if (!(ring.radius > 0)) {
      return std::nullopt;
    }
  }
  tube.spine = LineSpine{tube.start.center, tube.end.center};
  tube.radius = LinearRadius{tube.start.radius, tube.end.radius};
  return tube;
}

// Pipes that are longer where they were found to be too short, with numbers that can be told.
class LongerPipes {
 public:
  LongerPipes(const std::array<const PartSurface*, 2>& surfaces,
              const std::array<std::string, 2>& names, const PipeWalls& walls)
      : names_(names),
        walls_(walls),
        tubes_{straight_tube(*surfaces[0], names[0]), straight_tube(*surfaces[1], names[1])} {}

  // What would do for a fillet of this radius, or a smaller one.
  std::optional<std::string> what_would_do(double radius) {
    constexpr int kMost = 4;  // one after the other is found
    for (int i = 0; i < kMost; ++i) {
      const PartSurface first = Chain(longer_[0]), second = Chain(longer_[1]);
      const std::array<const PartSurface*, 2> both{&first, &second};
      const std::array<Pipe, 2> pipes = pipes_of(both, names_, walls_);
      const auto fits = [&](double tried) {
        return !fault_of(pipes, tried) && bore_takes(both, names_, tried, walls_.walls);
      };
      if (i > 0) {
        const auto largest =
            fits(radius) ? std::optional(radius) : largest_radius_below(radius, fits);
        if (largest) {
          return text(*largest == radius ? std::nullopt : largest);
        }
      }
      if (!lengthen(missing(pipes, radius))) {
        break;
      }
    }
    return std::nullopt;
  }

 private:
  static std::optional<Missing> missing(const std::array<Pipe, 2>& pipes, double radius) {
    try {
      return Search(pipes, radius).missing();
    } catch (const Error&) {
      return std::nullopt;  // one lies inside the other
    }
  }

  bool lengthen(const std::optional<Missing>& missing) {
    constexpr double kMore = 1.01;
    for (std::size_t i = 0; missing && i < 2; ++i) {
      for (std::size_t end = 0; end < 2; ++end) {
        const double more = missing->at(i).at(end);
        by_.at(i).at(end) = more > 0 ? std::stod(decimal(kMore * (by_.at(i).at(end) + more), 3))
                                     : by_.at(i).at(end);
      }
      const auto longer = lengthened(tubes_.at(i), by_.at(i));
      if (!longer) {
        return false;
      }
      longer_.at(i) = *longer;
    }
    return missing.has_value();
  }

  [[nodiscard]] std::string text(const std::optional<double>& radius) const {
    std::string result;
    for (const std::string& change : changes()) {
      result += (result.empty() ? "; with " : " and ") + change;
    }
    return result + (radius ? " a ball of radius " + decimal(*radius) : " the ball") + " would fit";
  }

  // As a document can say them. A branch begins on the axis of its run, unless it begins at a
  // point; where the run begins is where it is measured from.
  [[nodiscard]] std::vector<std::string> changes() const {
    const std::optional<BranchStart>& on = walls_.starts.on;
    const bool is_freed = on && by_.at(on->branch)[0] > 0;
    std::vector<std::string> result;
    if (is_freed) {
      result.push_back(on->tee.empty()
                           ? "'" + names_.at(on->branch) + "' from a point, not \"on\" '" +
                                 names_.at(1 - on->branch) + "',"
                           : "'" + on->tee + "' written as pipes from points and a fillet,");
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& [start, end] = by_.at(i);
      if (start > 0 || end > 0) {
        const bool is_run = on && !is_freed && i != on->branch;
        result.push_back(is_run && !on->tee.empty() ? longer_tee(*on, start, end) : longer(i));
        if (is_run && on->tee.empty() && start > 0) {
          result.push_back("'" + names_.at(on->branch) + "' \"at\" " + along(on->at + start));
        }
      }
    }
    return result;
  }

  [[nodiscard]] std::string longer(std::size_t i) const {
    std::string result;
    for (const End end : {End::start, End::end}) {
      const double by = by_.at(i).at(at(end));
      if (by > 0) {
        const std::string& port = walls_.starts.joined.at(i).at(at(end));
        result += (result.empty() ? "'" + names_.at(i) + "' longer " : " and ") + "by " +
                  decimal(by) + " at its " + std::string(name(end)) +
                  (port.empty() ? "" : ", which is at '" + port + "',");
      }
    }
    return result;
  }

  static std::string longer_tee(const BranchStart& on, double start, double end) {
    return "a \"length\" of " + along(on.run_length + start + end) + " of '" + on.tee +
           "' and its branch \"at\" " + along(on.at + start);
  }

  // In digits that tell it from where it was.
  static std::string along(double length) { return decimal(length, 12); }

  const std::array<std::string, 2>& names_;
  const PipeWalls& walls_;
  std::array<RingedSurface, 2> tubes_, longer_ = tubes_;
  Missing by_{};
};

std::string what_would_do(const std::array<const PartSurface*, 2>& surfaces,
                          const std::array<std::string, 2>& names, double radius,
                          const PipeWalls& walls) {
  const std::array<Pipe, 2> pipes = pipes_of(surfaces, names, walls);
  const auto fits = [&](double tried) { return !fault_of(pipes, tried); };
  const auto bore_fits = [&](double tried) {
    return bore_takes(surfaces, names, tried, walls.walls);
  };
  // No ball as large as both are long goes round.
  const double most = std::min(radius, pipes[0].length() + pipes[1].length());
  const auto outside = largest_radius_below(most, fits);
  if (!outside) {
    return LongerPipes(surfaces, names, walls)
        .what_would_do(radius)
        .value_or("; nor does a smaller ball fit");
  }
  const std::string named = "; the largest ball that fits, to 1 %, has a radius of ";
  if (bore_fits(*outside)) {
    return named + decimal(*outside);
  }
  if (const auto both = largest_radius_below(
          *outside, [&](double tried) { return fits(tried) && bore_fits(tried); })) {
    return named + decimal(*both);
  }
  std::string text = named + decimal(*outside) +
                     ", but with these walls neither it nor a smaller one fits inside, which "
                     "insulation alone does not ask for";
  for (const double share : {1.0, 0.5, 0.1}) {
    const double tried = share == 1 ? *outside : rounded(share * *outside, 2);
    const auto thinner = fits(tried) ? thinner_walls(surfaces, names, tried, walls) : std::nullopt;
    if (thinner) {
      return text + (share == 1 ? "; with it, " : "; with one of " + decimal(tried) + ", ") +
             *thinner + " would do";
    }
  }
  return text;
}

// Of walls that leave no bore: no ball would do that is not told of them.
std::string without_bore(const std::array<const PartSurface*, 2>& surfaces,
                         const std::array<std::string, 2>& names, const PipeWalls& walls) {
  std::string result;
  for (std::size_t i = 0; i < 2; ++i) {
    try {
      (void)narrowed(*surfaces.at(i), walls.walls.at(i));
    } catch (const Error& error) {
      result += "; '" + names.at(i) + "' is to be mended, too: " + error.message();
    }
  }
  return result.empty() ? result : result + "; whether a ball fits inside then is undecided";
}

// What `work` does with the pipes; where it refuses them, with what would do.
template <typename Work>
auto searched(const std::array<const PartSurface*, 2>& surfaces,
              const std::array<std::string, 2>& names, double radius, const PipeWalls& walls,
              const Work& work) {
  const std::array<Pipe, 2> pipes = pipes_of(surfaces, names, walls);
  try {
    return work(pipes);
  } catch (const Error& error) {
    throw Error(Errc::infeasible_blend, error.message() +
                                            what_would_do(surfaces, names, radius, walls) +
                                            without_bore(surfaces, names, walls));
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
                      const PipeWalls& walls) {
  return searched(surfaces, names, radius, walls,
                  [&](const auto& pipes) { return Search(pipes, radius).run(); });
}

Fillet fillet_without_loops(const std::array<const PartSurface*, 2>& surfaces,
                            const std::array<std::string, 2>& names, double radius,
                            const PipeWalls& walls) {
  return searched(surfaces, names, radius, walls,
                  [&](const auto& pipes) { return Search::without_loops(pipes, radius); });
}

void find_loops(Fillet& fillet, const std::array<const PartSurface*, 2>& surfaces,
                const std::array<std::string, 2>& names, const PipeWalls& walls) {
  fillet = searched(surfaces, names, fillet.radius, walls,
                    [&](const auto& pipes) { return Search(pipes, fillet).with_loops(); });
}

void prove(Fillet& fillet, const std::array<const PartSurface*, 2>& surfaces,
           const std::array<std::string, 2>& names, const PipeWalls& walls) {
  searched(surfaces, names, fillet.radius, walls,
           [&](const auto& pipes) { Search(pipes, fillet).prove(fillet); });
}

std::optional<std::string> fillet_fault(const std::array<const PartSurface*, 2>& surfaces,
                                        const std::array<std::string, 2>& names, double radius) {
  return fault_of(pipes_of(surfaces, names, {}), radius);
}

Fillet cope_between(const std::array<const PartSurface*, 2>& surfaces,
                    const std::array<std::string, 2>& names, const PipeWalls& walls) {
  const std::array<Pipe, 2> pipes = pipes_of(surfaces, names, walls);
  try {
    return Search(pipes, 0).run();
  } catch (const Error& error) {
    throw Error(Errc::infeasible_blend, error.message());
  }
}

}  // namespace dupin::assembly
