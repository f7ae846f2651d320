#include "network/piping_reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/kernel/decimal.h"
#include "numbers/angle.h"

namespace dupin::network {
namespace {

// Pipes that run along each other are no branches.
constexpr double kAlong = 0.9;

// How far the pipe that ends at `end` in direction `outward` has to go to be level with the axis of
// `run`; none if it does not end in its wall.
std::optional<double> reach(const Vec3& end, const Vec3& outward, const Span& run, double snap) {
  const Vec3 &from = run.ends[0].point, way = run.ends[1].point - from;
  const double length = way.norm(), radius = std::max(run.radii[0], run.radii[1]);
  if (!(length > 0)) {
    return std::nullopt;
  }
  const Vec3 along = way / length, offset = end - from;
  const double level = offset.dot(along), cosine = outward.dot(along);
  const double aside = (offset - level * along).norm();
  if (level < 0 || level > length || aside > radius + snap || std::abs(cosine) > kAlong) {
    return std::nullopt;
  }
  // The nearest point to the run's axis on the pipe's own.
  return (level * cosine - offset.dot(outward)) / (1 - cosine * cosine);
}

// Spans by where they are along x, to find those near a point.
class SpanIndex {
 public:
  SpanIndex(const std::vector<Span>& spans, double snap) {
    entries_.reserve(spans.size());
    for (std::size_t i = 0; i < spans.size(); ++i) {
      const Span& span = spans[i];
      const double around = std::max(span.radii[0], span.radii[1]) + snap;
      const auto [low, high] = std::minmax(span.ends[0].point.x(), span.ends[1].point.x());
      entries_.push_back({low - around, high + around, i});
    }
    std::ranges::sort(entries_, {}, &Entry::low);
    highest_.reserve(entries_.size());
    double highest = -std::numeric_limits<double>::infinity();
    for (const Entry& entry : entries_) {
      highest = std::max(highest, entry.high);
      highest_.push_back(highest);
    }
  }

  /// Those that may hold the point, in their order.
  [[nodiscard]] std::vector<std::size_t> near(const Vec3& point) const {
    std::vector<std::size_t> result;
    auto i = std::size_t(std::ranges::upper_bound(entries_, point.x(), {}, &Entry::low) -
                         entries_.begin());
    while (i > 0 && highest_[i - 1] >= point.x()) {
      --i;
      if (entries_[i].high >= point.x()) {
        result.push_back(entries_[i].span);
      }
    }
    std::ranges::sort(result);
    return result;
  }

 private:
  struct Entry {
    double low, high;
    std::size_t span;
  };
  std::vector<Entry> entries_;
  std::vector<double> highest_;  // of the entries up to each
};

}  // namespace

namespace {

// Where a run's axis passes, in radii of it, by the point that an olet's branch begins at.
constexpr double kOnAxis = 0.5;

Vec3 nearest_on_line(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  const double squared = way.squaredNorm();
  const double share = squared > 0 ? std::clamp((point - from).dot(way) / squared, 0.0, 1.0) : 0;
  return from + share * way;
}

// The point of a bend's axis that is nearest: of the straight piece of this leg, or of the arc as
// long as the shorter leg, or as its bend radius asks for.
Vec3 nearest_on_bend(const PipingLine& line, const Vec3& point, const Span& leg,
                     const Span& other) {
  const Vec3& corner = leg.ends[1].point;
  const Vec3 back = (leg.ends[0].point - corner).normalized(),
             on = (other.ends[0].point - corner).normalized();
  const double half = numbers::angle_between(back, on) / 2;
  double tangent = std::min(leg.length(), other.length());
  if (const auto& asked = line.components[leg.component].bend_radius) {
    tangent = std::min(tangent, *asked / std::tan(half));
  }
  const Vec3 begin = corner + tangent * back, end = corner + tangent * on;
  Vec3 straight = nearest_on_line(point, leg.ends[0].point, begin);
  const Vec3 middle = corner + tangent / std::cos(half) * (back + on).normalized();
  const Vec3 axis = (begin - middle).cross(end - middle).normalized();
  const Vec3 level = point - middle - (point - middle).dot(axis) * axis;
  if (!(level.norm() > 0) || (begin - middle).cross(level).dot(axis) < 0 ||
      level.cross(end - middle).dot(axis) < 0) {
    return straight;
  }
  const Vec3 turned = middle + tangent * std::tan(half) * level.normalized();
  return (turned - point).norm() < (straight - point).norm() ? turned : straight;
}

// The point of the axis of what is made of the span that is nearest.
Vec3 nearest_on_axis(const PipingLine& line, const PipingSpans& spans, const Vec3& point,
                     const Span& run) {
  return run.role == SpanRole::bend_leg && run.other_leg
             ? nearest_on_bend(line, point, run, spans.spans[*run.other_leg])
             : nearest_on_line(point, run.ends[0].point, run.ends[1].point);
}

// Whether a branch begins where there is nothing that it could branch off.
bool is_stray(const PipingLine& line, const PipingSpans& spans, const Span& branch, double snap) {
  const Vec3& from = branch.ends[0].point;
  return std::ranges::none_of(spans.spans, [&](const Span& run) {
    return run.component != branch.component &&
           (nearest_on_axis(line, spans, from, run) - from).norm() <=
               std::max(run.radii[0], run.radii[1]) + snap;
  });
}

// The end that lies in the run is none of the line, unless it is thicker than that.
void hide_in_run(const PipingLine& line, const Span& run, double snap, Span& branch,
                 std::size_t side, LineNotes& notes) {
  SpanEnd& end = branch.ends.at(side);
  const Vec3 &start = run.ends[0].point, way = run.ends[1].point - start;
  const double share = std::clamp((end.point - start).dot(way) / way.squaredNorm(), 0.0, 1.0);
  end.is_hidden =
      branch.radii.at(side) <= run.radii[0] + share * (run.radii[1] - run.radii[0]) + snap;
  if (!end.is_hidden) {
    notes.add(line.components[branch.component],
              "is thicker than " + run.name + ", in which it ends, and sticks out of it there");
  }
}

// Whether a span's end disc lies in the run.
bool is_disc_in(const Span& span, std::size_t side, const Span& run, double snap) {
  constexpr int kPoints = 64;
  const Vec3& from = run.ends[0].point;
  const double length = (run.ends[1].point - from).norm();
  const Vec3 along = (run.ends[1].point - from) / length;
  const Vec3 axis = (span.ends.at(side).point - span.ends.at(1 - side).point) / span.length();
  const Vec3 first = axis.unitOrthogonal(), second = axis.cross(first);
  for (int i = 0; i < kPoints; ++i) {
    const double turn = 2 * std::numbers::pi * i / kPoints;
    const Vec3 point = span.ends.at(side).point +
                       span.radii.at(side) * (std::cos(turn) * first + std::sin(turn) * second);
    const double level = (point - from).dot(along), share = level / length;
    const double radius = run.radii[0] + share * (run.radii[1] - run.radii[0]);
    if (level < -snap || level > length + snap ||
        (point - from - level * along).norm() > radius + snap) {
      return false;
    }
  }
  return true;
}

// The pipe that an olet branches off: the first one about whose axis its branch begins, else that
// in whose wall it does.
struct OletRun {
  std::size_t span = 0;
  bool is_in_wall = false;
  std::optional<double> further;  ///< to be level with the axis
};

std::optional<OletRun> run_of_olet(const SpanIndex& index, const PipingLine& line,
                                   const PipingSpans& spans, const Span& branch, double snap) {
  const Vec3& from = branch.ends[0].point;
  const Vec3 outward = (from - branch.ends[1].point).normalized();
  std::optional<OletRun> in_wall;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t near : index.near(from)) {
    const Span& run = spans.spans[near];
    const Vec3 &start = run.ends[0].point, way = run.ends[1].point - start;
    const double share = (from - start).dot(way) / way.squaredNorm();
    if (run.component == branch.component) {
      continue;
    }
    const bool is_bend = run.role == SpanRole::bend_leg;
    const double radius = std::min(run.radii[0], run.radii[1]);
    const Vec3 to_axis = nearest_on_axis(line, spans, from, run) - from;
    const double aside = (is_bend ? to_axis : Vec3(start + share * way - from)).norm() / radius;
    const auto further = !is_bend                          ? reach(from, outward, run, snap)
                         : aside * radius <= radius + snap ? std::optional(to_axis.dot(outward))
                                                           : std::nullopt;
    if (aside <= kOnAxis) {
      if (!is_bend && share > 0 && share < 1) {
        return OletRun{near, false, further};
      }
    } else if (further && aside < least) {
      least = aside;
      in_wall = OletRun{near, true, further};
    }
  }
  return in_wall;
}

// A branch that passes the axis by may not lie in the pipe with all of its end.
void note_in_wall(const PipingComponent& olet, const Span& run, double further, double snap,
                  Span& branch, LineNotes& notes) {
  SpanEnd& end = branch.ends[0];
  if (run.role == SpanRole::straight && end.is_hidden && !is_disc_in(branch, 0, run, snap)) {
    end.is_hidden = false;
    notes.add(olet, "its branch begins in " + run.name + " only in part, and sticks out of it");
  } else if (further != 0) {
    notes.add(olet, "its centre lies in the wall of " + run.name + "; its branch is " +
                        (further > 0 ? "continued" : "shortened") + " by " +
                        decimal(std::abs(further), kMessageDigits) + " to its axis");
  }
}

// An olet, which is one arm from the axis or the wall of another component's pipe, is a branch of
// that.
void find_olets(const SpanIndex& index, const PipingLine& line, double snap, PipingSpans& spans,
                LineNotes& notes) {
  for (std::size_t i = 0; i < spans.spans.size(); ++i) {
    Span& branch = spans.spans[i];
    const PipingComponent& component = line.components[branch.component];
    if (component.shape != PipingShape::fitting || component.name != branch.name ||
        branch.ends[0].port || branch.role != SpanRole::straight) {
      continue;
    }
    Vec3& from = branch.ends[0].point;
    if (const auto found = run_of_olet(index, line, spans, branch, snap)) {
      const Span& run = spans.spans[found->span];
      if (run.role == SpanRole::straight) {
        spans.branches.push_back({found->span, i});
      }
      const bool is_moved = found->further && *found->further > -branch.length() / 2;
      if (is_moved) {
        from += *found->further * (from - branch.ends[1].point).normalized();
      }
      hide_in_run(line, run, snap, branch, 0, notes);
      if (found->is_in_wall) {
        note_in_wall(component, run, is_moved ? *found->further : 0, snap, branch, notes);
      }
    } else if (is_stray(line, spans, branch, snap)) {
      notes.add(component,
                "its centre lies in no other component; its branch begins there, joined to "
                "nothing");
      branch.ends[0].is_hidden = false;
    }
  }
}

}  // namespace

void reach_runs(const PipingLine& line, const PipingOptions& options, PipingSpans& spans,
                LineNotes& notes) {
  const SpanIndex index(spans.spans, options.snap);
  find_olets(index, line, options.snap, spans, notes);
  for (std::size_t i = 0; i < spans.spans.size(); ++i) {
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      Span& span = spans.spans[i];
      SpanEnd& end = span.ends[side];
      if (span.role != SpanRole::straight || !end.port || end.joint || !(span.length() > 0)) {
        continue;
      }
      const Vec3 outward = (end.point - span.ends[1 - side].point) / span.length();
      for (const std::size_t near : index.near(end.point)) {
        const Span& run = spans.spans[near];
        if (run.component == span.component) {
          continue;
        }
        const auto further = reach(end.point, outward, run, options.snap);
        if (!further) {
          continue;
        }
        end.is_in_run = true;
        if (*further <= 0) {
          end.is_hidden = is_disc_in(span, side, run, options.snap);
          if (!end.is_hidden) {
            notes.add(line.components[span.component],
                      "its end lies in " + run.name + " only in part, and sticks out of it");
          }
        } else {
          end.point += *further * outward;
          if (run.role == SpanRole::straight) {
            spans.branches.push_back({near, i});
          }
          notes.add(line.components[span.component],
                    "ends in the wall of " + run.name + "; continued by " +
                        decimal(*further, kMessageDigits) + " to its axis");
          hide_in_run(line, run, options.snap, span, side, notes);
          break;
        }
      }
    }
  }
}

}  // namespace dupin::network
