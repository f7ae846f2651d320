#include "network/piping_stretches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dupin/kernel/decimal.h"
#include "numbers/angle.h"

namespace dupin::network {
namespace {

// A bend whose radius asks for this much less than its legs has straight pieces.
constexpr double kShorterArc = 0.99;
// Of the larger radius, the least length of a cone between two; and of the pipe it is made in, the
// most.
constexpr double kStepLength = 0.25, kStepOfPipe = 0.5;
// Of a pipe, what a bridge at one of its ends may take.
constexpr double kBridgeOfPipe = 0.45;
// A bend's centre line keeps at least this many radii off its axis.
constexpr double kLeastBend = 1.0001;

class Planner {
 public:
  Planner(const PipingLine& line, const PipingOptions& options, const PipingSpans& spans,
          const Chain& chain, std::vector<PipingJoint>& joints, LineNotes& notes)
      : line_(line),
        options_(options),
        spans_(spans),
        chain_(chain),
        joints_(joints),
        notes_(notes) {}

  ChainPlan run() {
    result_.arcs.resize(chain_.seams.size());
    for (std::size_t k = 1; k < chain_.legs.size(); ++k) {
      if (chain_.seams[k].kind == SeamKind::corner) {
        result_.arcs[k] = arc(chain_.legs[k - 1], chain_.legs[k]);
      }
    }
    result_.stretches.resize(chain_.legs.size());
    result_.places.resize(chain_.legs.size());
    for (std::size_t k = 0; k < chain_.legs.size(); ++k) {
      cut(k);
      step_between(k);
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] const Span& span(const ChainElement& element) const {
    return spans_.spans[element.span];
  }

  [[nodiscard]] double radius(const ChainElement& element, std::size_t side) const {
    return span(element).radii[element.is_reversed ? 1 - side : side];
  }

  Arc arc(const Leg& in, const Leg& out) {
    const Span& leg = span(in.elements.back());
    const PipingComponent& bend = line_.components[leg.component];
    const double first = in.nodes.back() - begin_level(in, in.elements.size() - 1),
                 second = end_level(out, 0);
    const double half = numbers::angle_between(in.direction, out.direction) / 2;
    Arc result{leg.component, std::min(first, second), leg.radii[0], false};
    if (const auto common = common_tangent(in, out, first, second)) {
      result.tangent = *common;
    }
    if (bend.bend_radius && *bend.bend_radius * std::tan(half) < kShorterArc * result.tangent) {
      result.tangent = *bend.bend_radius * std::tan(half);
    }
    const double bend_radius = result.tangent / std::tan(half);
    if (!(bend_radius > kLeastBend * result.radius)) {
      notes_.refuse(bend,
                    "its bend radius of " + decimal(bend_radius, kMessageDigits) +
                        " is not larger than its pipe's radius of " +
                        decimal(result.radius, kMessageDigits),
                    Errc::irregular_surface);
      result.is_left_out = true;
    } else if (bend.bend_radius && kShorterArc * *bend.bend_radius > bend_radius) {
      notes_.add(bend, "its legs are too short for its bend radius of " +
                           decimal(*bend.bend_radius, kMessageDigits) + "; it has one of " +
                           decimal(bend_radius, kMessageDigits));
    }
    return result;
  }

  // The nearest to the middle of both legs that moves no end beside the bend by more than the snap
  // tolerance, with what the axes take it aside, or where there is none, though nothing but an arc
  // has room on either leg, what moves ends least; else none.
  [[nodiscard]] std::optional<double> common_tangent(const Leg& in, const Leg& out, double first,
                                                     double second) const {
    double least = 0, most = std::numeric_limits<double>::infinity();
    const auto keep = [&](const Leg& leg, double corner, const SpanEnd& end) {
      const double level = level_of(leg, end), aside = (point_at(leg, level) - end.point).norm();
      const double room = std::sqrt(std::max(options_.snap * options_.snap - aside * aside, 0.0));
      least = std::max(least, std::abs(corner - level) - room);
      most = std::min(most, std::abs(corner - level) + room);
    };
    const std::size_t last = in.elements.size() - 1;
    keep(in, in.nodes.back(), begin_of(spans_, in.elements[last]));
    if (last > 0 && !is_gap_before(in, last)) {
      keep(in, in.nodes.back(), end_of(spans_, in.elements[last - 1]));
    }
    keep(out, 0, end_of(spans_, out.elements[0]));
    if (out.elements.size() > 1 && !is_gap_before(out, 1)) {
      keep(out, 0, begin_of(spans_, out.elements[1]));
    }
    if (least <= most) {
      return std::clamp((first + second) / 2, least, most);
    }
    return std::abs(first - second) <= options_.snap ? std::optional((least + most) / 2)
                                                     : std::nullopt;
  }

  void cut(std::size_t k) {
    const Leg& leg = chain_.legs[k];
    std::vector<double> levels = leg.nodes;
    auto& stretches = result_.stretches[k];
    const std::size_t last = leg.elements.size() - 1;
    // A leg may consist of both bends' legs alone, so both limits may concern one element each.
    const double begin = result_.arcs[k] ? result_.arcs[k]->tangent : levels.front();
    const double end =
        result_.arcs[k + 1] ? levels.back() - result_.arcs[k + 1]->tangent : levels.back();
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const bool is_first = i == 0 || (i == 1 && result_.arcs[k]);
      const bool is_last =
          i == levels.size() - 1 || (i == levels.size() - 2 && result_.arcs[k + 1]);
      if (is_first && levels[i] - begin <= options_.snap) {
        levels[i] = begin;
      } else if (is_last && end - levels[i] <= options_.snap) {
        levels[i] = end;
      }
    }
    double here = begin;
    for (std::size_t i = 0; i <= last; ++i) {
      const ChainElement& element = leg.elements[i];
      const Span& own = span(element);
      const double to = i == last                   ? end
                        : is_gap_before(leg, i + 1) ? std::min(end_level(leg, i), end)
                                                    : std::min(levels[i + 1], end);
      here = i > 0 && is_gap_before(leg, i) ? begin_level(leg, i) : here;
      result_.places[k].push_back(place(k, i, {here, to}, end));
      if (to - here <= options_.snap) {
        if (own.role == SpanRole::straight) {
          notes_.add(line_.components[own.component],
                     own.name + " is shorter than the snap tolerance between its neighbours");
        }
        continue;
      }
      Stretch stretch{own.name, own.component, {here, to}, {}, own.is_solid, element.span, {}};
      stretch.radii = {radius(element, 0), radius(element, 1)};
      if (own.role == SpanRole::bend_leg) {
        stretch.name += element.is_reversed ? "-leg2" : "-leg";
        stretch.span.reset();
      }
      if (i > 0) {
        stretch.joint_before = begin_of(spans_, element).joint;
        stretch.is_behind_gap = is_gap_before(leg, i);
      }
      stretches.push_back(stretch);
      here = to;
    }
    begin_arc_at(k, here, end);
  }

  // Of an element between these levels. A bend's ends are those of its arc, if no straight piece is
  // left of its leg, and `end` is where the next arc begins.
  [[nodiscard]] std::optional<std::array<double, 2>> place(std::size_t k, std::size_t i,
                                                           const std::array<double, 2>& levels,
                                                           double end) const {
    const Leg& leg = chain_.legs[k];
    const bool is_made = levels[1] - levels[0] > options_.snap;
    if (span(leg.elements[i]).role == SpanRole::straight) {
      // What overlaps is set back.
      return is_made ? std::optional(std::array{
                           levels[0], is_gap_before(leg, i + 1) ? end_level(leg, i) : levels[1]})
                     : std::nullopt;
    }
    const bool is_behind_corner = leg.elements[i].is_reversed;
    if (!is_made && result_.arcs[is_behind_corner ? k : k + 1]->is_left_out) {
      return std::nullopt;
    }
    if (is_behind_corner) {
      return std::array{leg.nodes.front(), levels[is_made ? 1 : 0]};
    }
    const bool is_bridged = !is_made && i > 0 && is_gap_before(leg, i);
    return std::array{is_bridged ? end : levels[0], leg.nodes.back()};
  }

  // The arc behind this leg goes on from the last stretch, where what is left between both is too
  // short to become one.
  void begin_arc_at(std::size_t k, double here, double end) {
    const Leg& leg = chain_.legs[k];
    const std::size_t last = leg.elements.size() - 1;
    auto& arc = result_.arcs[k + 1];
    if (arc && !arc->is_left_out && here != end && !(last > 0 && is_gap_before(leg, last))) {
      arc->tangent = leg.nodes.back() - here;
    }
  }

  [[nodiscard]] static double level_of(const Leg& leg, const SpanEnd& end) {
    return (end.point - leg.origin).dot(leg.direction);
  }

  [[nodiscard]] bool is_gap_before(const Leg& leg, std::size_t i) const {
    if (i == leg.elements.size()) {
      return false;
    }
    const auto& joint = begin_of(spans_, leg.elements[i]).joint;
    return joint && spans_.pairs[*joint].distance > options_.snap;
  }

  // Of an element: its node, but for those at gaps, where it stays where it is.
  [[nodiscard]] double begin_level(const Leg& leg, std::size_t i) const {
    return i > 0 && is_gap_before(leg, i) ? level_of(leg, begin_of(spans_, leg.elements[i]))
                                          : leg.nodes[i];
  }

  [[nodiscard]] double end_level(const Leg& leg, std::size_t i) const {
    return is_gap_before(leg, i + 1) ? level_of(leg, end_of(spans_, leg.elements[i]))
                                     : leg.nodes[i + 1];
  }

  // Where radii differ, in the larger pipe if it is straight, else in the other one.
  void step_between(std::size_t k) {
    auto& stretches = result_.stretches[k];
    std::vector<Stretch> result;
    result.reserve(2 * stretches.size() + 1);
    const auto& before = result_.arcs[k];
    const auto& after = result_.arcs[k + 1];
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      Stretch own = stretches[i];
      if (i > 0) {
        const double previous = result.back().radii[1];
        if (own.is_behind_gap) {
          result.push_back(bridge(result.back(), own));
        } else if (previous != own.radii[0]) {
          const bool in_previous = previous > own.radii[0];
          Stretch step =
              in_previous ? cut_end(result.back(), own.radii[0]) : cut_begin(own, previous);
          name_step(step, own.joint_before);
          result.push_back(step);
        }
      } else if (before && own.is_behind_gap) {
        if (!before->is_left_out) {
          result.push_back(
              bridge_beside(own, 0, before->tangent, before->radius, *own.joint_before));
        }
      } else if (before && before->radius != own.radii[0]) {
        Stretch step = cut_begin(own, before->radius);
        name_step(step, begin_joint(k));
        result.push_back(step);
      }
      result.push_back(own);
    }
    bridge_offsets(k, result);
    if (ends_at_gap(k)) {
      close_gap_at_end(k, result);
    } else if (after && !result.empty() && result.back().radii[1] != after->radius) {
      Stretch step = cut_end(result.back(), after->radius);
      name_step(step, begin_of(spans_, chain_.legs[k].elements.back()).joint);
      result.push_back(step);
    }
    stretches = std::move(result);
  }

  // A cylinder or cone that closes a gap along the axis: both sides are set back by as much as ends
  // overlap, and by half of a step between their radii.
  Stretch bridge(Stretch& before, Stretch& after) {
    const double overlap = std::max(before.levels[1] - after.levels[0], 0.0);
    const double setback =
        overlap + std::max(bridged_step(before.radii[1], after.radii[0]) / 2, options_.snap);
    const Stretch origin = before;
    set_back(before, 1, setback);
    set_back(after, 0, setback);
    return bridge_of(origin, {before.levels[1], after.levels[0]}, {before.radii[1], after.radii[0]},
                     *after.joint_before);
  }

  [[nodiscard]] static double bridged_step(double from, double to) {
    return from == to ? 0 : std::max(std::abs(from - to), kStepLength * std::max(from, to));
  }

  // The same beside an arc, of which nothing can be taken, and which is level with this end.
  Stretch bridge_beside(Stretch& pipe, std::size_t end, double level, double radius,
                        std::size_t joint) {
    const double overlap =
        std::max(end == 0 ? level - pipe.levels[0] : pipe.levels[1] - level, 0.0);
    const Stretch origin = pipe;
    set_back(pipe, end,
             overlap + std::max(bridged_step(pipe.radii[end], radius), 2 * options_.snap));
    return end == 0 ? bridge_of(origin, {level, pipe.levels[0]}, {radius, pipe.radii[0]}, joint)
                    : bridge_of(origin, {pipe.levels[1], level}, {pipe.radii[1], radius}, joint);
  }

  // Whether a gap lies between the leg's last stretch and the arc behind it.
  [[nodiscard]] bool ends_at_gap(std::size_t k) const {
    const Leg& leg = chain_.legs[k];
    const auto& arc = result_.arcs[k + 1];
    const auto& stretches = result_.stretches[k];
    const bool has_piece = !stretches.empty() && !stretches.back().span &&
                           stretches.back().component == span(leg.elements.back()).component;
    return arc && !arc->is_left_out && leg.elements.size() > 1 && !has_piece &&
           is_gap_before(leg, leg.elements.size() - 1);
  }

  // Gaps to an eccentric part before or behind the leg, which begins or ends on its axis.
  void bridge_offsets(std::size_t k, std::vector<Stretch>& stretches) {
    const Leg& leg = chain_.legs[k];
    if (leg.is_offset || stretches.empty()) {
      return;
    }
    const auto gap = [&](const SpanEnd& end, SeamKind seam) -> std::optional<std::size_t> {
      return seam == SeamKind::offset && end.joint &&
                     spans_.pairs[*end.joint].distance > options_.snap
                 ? end.joint
                 : std::nullopt;
    };
    if (const auto joint = gap(end_of(spans_, leg.elements.back()), chain_.seams[k + 1].kind)) {
      const SpanEnd& there = begin_of(spans_, chain_.legs[k + 1].elements.front());
      Stretch& own = stretches.back();
      stretches.push_back(bridge_beside(own, 1, level_of(leg, there), own.radii[1], *joint));
    }
    if (const auto joint = gap(begin_of(spans_, leg.elements.front()), chain_.seams[k].kind)) {
      const SpanEnd& there = end_of(spans_, chain_.legs[k - 1].elements.back());
      Stretch& own = stretches.front();
      const Stretch made = bridge_beside(own, 0, level_of(leg, there), own.radii[0], *joint);
      stretches.insert(stretches.begin(), made);
    }
  }

  // By a bridge beside the arc, or, of a leg that has nothing else, between two arcs.
  void close_gap_at_end(std::size_t k, std::vector<Stretch>& stretches) {
    const Leg& leg = chain_.legs[k];
    const Arc& after = *result_.arcs[k + 1];
    const double level = leg.nodes.back() - after.tangent;
    const std::size_t joint = *begin_of(spans_, leg.elements.back()).joint;
    if (!stretches.empty()) {
      stretches.push_back(bridge_beside(stretches.back(), 1, level, after.radius, joint));
    } else if (const auto& before = result_.arcs[k]; before && !before->is_left_out) {
      Stretch origin;
      origin.component = span(leg.elements.front()).component;
      stretches.push_back(
          bridge_of(origin, {before->tangent, level}, {before->radius, after.radius}, joint));
    }
  }

  Stretch bridge_of(Stretch origin, const std::array<double, 2>& levels,
                    const std::array<double, 2>& radii, std::size_t position) {
    PipingJoint& joint = joints_[position];
    origin.levels = levels;
    origin.radii = radii;
    origin.is_solid = false;
    origin.span.reset();
    origin.is_behind_gap = false;
    origin.name = "bridge-" + std::to_string(joint.lines[0]) + "-" + std::to_string(joint.lines[1]);
    joint.state = JointState::bridged;
    joint.part = origin.name;
    return origin;
  }

  // Takes that much of its end, at most a part of it; a cone keeps its slope.
  static void set_back(Stretch& stretch, std::size_t end, double by) {
    const double taken = std::min(by, kBridgeOfPipe * stretch.length());
    stretch.radii[end] += taken / stretch.length() * (stretch.radii[1 - end] - stretch.radii[end]);
    stretch.levels[end] += end == 0 ? taken : -taken;
  }

  // Of a leg that begins with a bend's.
  [[nodiscard]] std::optional<std::size_t> begin_joint(std::size_t k) const {
    return end_of(spans_, chain_.legs[k].elements.front()).joint;
  }

  void name_step(Stretch& step, std::optional<std::size_t> joint) {
    step.is_solid = false;
    step.span.reset();
    if (!joint) {
      step.name += "-step";
      return;
    }
    step.name = "step-" + std::to_string(joints_[*joint].lines[0]) + "-" +
                std::to_string(joints_[*joint].lines[1]);
    joints_[*joint].state = JointState::stepped;
    joints_[*joint].part = step.name;
  }

  [[nodiscard]] static double step_length(const Stretch& in, double from, double to) {
    return std::min(std::max(std::abs(from - to), kStepLength * std::max(from, to)),
                    kStepOfPipe * in.length());
  }

  // The cone to `radius` that takes the stretch's last piece.
  static Stretch cut_end(Stretch& from, double radius) {
    Stretch step = from;
    step.levels[0] = from.levels[1] -= step_length(from, from.radii[1], radius);
    step.radii = {from.radii[1], radius};
    return step;
  }

  // The cone from `radius` that takes its first one.
  static Stretch cut_begin(Stretch& from, double radius) {
    Stretch step = from;
    step.levels[1] = from.levels[0] += step_length(from, radius, from.radii[0]);
    step.radii = {radius, from.radii[0]};
    return step;
  }

  const PipingLine& line_;
  const PipingOptions& options_;
  const PipingSpans& spans_;
  const Chain& chain_;
  std::vector<PipingJoint>& joints_;
  LineNotes& notes_;
  ChainPlan result_;
};

}  // namespace

PartShape shape_of(const Leg& leg, const Stretch& stretch) {
  const Vec3 from = point_at(leg, stretch.levels[0]), to = point_at(leg, stretch.levels[1]);
  if (stretch.radii[0] == stretch.radii[1]) {
    return PipeBetween{from, to, stretch.radii[0], {}};
  }
  return ConeBetween{from, to, stretch.radii[0], stretch.radii[1], {}, {}};
}

ChainPlan plan(const PipingLine& line, const PipingOptions& options, const PipingSpans& spans,
               const Chain& chain, std::vector<PipingJoint>& joints, LineNotes& notes) {
  return Planner(line, options, spans, chain, joints, notes).run();
}

}  // namespace dupin::network
