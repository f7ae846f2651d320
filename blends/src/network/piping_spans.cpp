#include "network/piping_spans.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dupin/kernel/decimal.h"
#include "network/piping_radii.h"

namespace dupin::network {
namespace {

// Two arms of a fitting are its run if they are at most 60 degrees off a straight line and an arc
// between them fits, whose radius is at least this many times the pipe's and which passes by the
// centre at a distance of at most this part of it, as branches begin there.
constexpr double kRunCosine = 0.5, kArcOfRun = 1.2, kArcBesideCenter = 0.1;
// A run whose centre lies off it is still a line if what is joined to it goes on along that rather
// than along its arms, or, where nothing is, if these are at most 10 degrees off one.
constexpr double kAlmostStraight = 0.985;
// An arm's foot is where the run is if its centre is further off than this many radii of the run.
constexpr double kBesideRun = 0.5;
// The cosine of an arm that runs along its run more than away from it.
constexpr double kAlongRun = 0.9;
// An arm begins off the ball's centre, so that no two begin at the same place, by this much of its
// leg, but at most of what the ball is thicker than the arms: the mouth then lies inside of the
// ball, and so does that of the bore inside of the ball's, whatever the wall.
constexpr double kInBall = 0.2, kInBallBeyondArm = 0.5;
// A bend that turns by more than 175 degrees has no corner to speak of.
constexpr double kTurnsBack = -0.996;
// By the thickest arm that runs into it.
constexpr double kBall = 1.05;
// Of the thicker radius, the least length of an eccentric reducer that has none.
constexpr double kFlatReducer = 0.25;
// Of a leg of a bend, where a branch along it begins; and the cosine that says that it is along it.
constexpr double kBranchOnLeg = 0.02, kAlongLeg = 0.9998;

double turn_cosine(const PipingComponent& bend) {
  const Vec3 in = *bend.center - bend.ports[0].center, out = bend.ports[1].center - *bend.center;
  return in.dot(out) / (in.norm() * out.norm());
}

class Spans {
 public:
  Spans(const PipingLine& line, const PipingOptions& options, LineNotes& notes)
      : line_(line),
        options_(options),
        notes_(notes),
        is_left_out_(line.components.size()),
        is_short_(line.components.size()) {}

  PipingSpans run() {
    for (std::size_t i = 0; i < line_.components.size(); ++i) {
      is_left_out_[i] = is_empty(i);
    }
    pair_up();
    note_short();
    refuse_without_radius();
    first_port_.resize(line_.components.size(), 0);
    for (std::size_t i = result_.ports.size(); i-- > 0;) {
      first_port_[result_.ports[i].component] = i;
    }
    result_.span_of_port.resize(result_.ports.size());
    partners_.resize(result_.ports.size());
    for (const PortPair& pair : result_.pairs) {
      partners_[pair.first] = pair.second;
      partners_[pair.second] = pair.first;
    }
    for (std::size_t i = 0; i < line_.components.size(); ++i) {
      if (!is_left_out_[i]) {
        add(i);
      }
    }
    link();
    for (std::size_t i = 0; i < result_.spans.size(); ++i) {
      lengthen_flat_reducer(i);
    }
    return std::move(result_);
  }

 private:
  // What is no longer than the snap tolerance: a joint, if what it lies between meets there.
  void note_short() {
    std::vector<std::pair<double, std::size_t>> by_x;  // pairs, by where they are
    for (std::size_t k = 0; k < result_.pairs.size(); ++k) {
      by_x.emplace_back(result_.ports[result_.pairs[k].first].center.x(), k);
    }
    std::ranges::sort(by_x);
    for (std::size_t i = 0; i < line_.components.size(); ++i) {
      if (!is_short_[i]) {
        continue;
      }
      const PipingComponent& component = line_.components[i];
      const auto is_at = [&](std::size_t port) {
        return std::ranges::any_of(component.ports, [&](const PipingPort& own) {
          return (own.center - result_.ports[port].center).norm() <= options_.snap;
        });
      };
      const auto& ends = component.ports;
      const auto [low, high] = std::minmax(ends[0].center.x(), ends[1].center.x());
      bool is_joined = false;
      for (auto pair =
               std::ranges::lower_bound(by_x, std::pair(low - options_.snap, std::size_t{0}));
           pair != by_x.end() && pair->first <= high + options_.snap && !is_joined; ++pair) {
        const PortPair& joint = result_.pairs[pair->second];
        is_joined = is_at(joint.first) && is_at(joint.second);
      }
      notes_.add(component,
                 std::string("has no length beyond the snap tolerance; ") +
                     (is_joined ? "its neighbours are joined" : "nothing is made of it"));
    }
  }

  // Whether it has no length, refused if it makes no sense.
  bool is_empty(std::size_t i) {
    const PipingComponent& component = line_.components[i];
    const auto& ports = component.ports;
    const auto refused = [&](const std::string& why) {
      notes_.refuse(component, why);
      return true;
    };
    if (const auto found = options_.refused.find(component.name); found != options_.refused.end()) {
      return refused(found->second);
    }
    if (ports.empty()) {
      return refused("it has no end in space");
    }
    if (!is_finite(component)) {
      return refused("its coordinates and lengths must be finite");
    }
    const bool is_bend = component.shape == PipingShape::bend;
    if (!is_bend && component.shape != PipingShape::fitting && ports.size() > 2) {
      return refused("it has " + std::to_string(ports.size()) + " ends instead of two");
    }
    if (component.shape == PipingShape::straight || is_bend) {
      if (ports.size() < 2) {
        return refused("it has one end instead of two");
      }
      if ((ports[0].center - ports[1].center).norm() <= options_.snap) {
        is_short_[i] = true;
        return true;
      }
    }
    if (!component.center &&
        (component.shape == PipingShape::bend || component.shape == PipingShape::fitting)) {
      return refused("it has no centre point");
    }
    if (is_turned(component) && turn_cosine(component) < kTurnsBack) {
      return refused("it turns back upon itself");
    }
    return false;
  }

  [[nodiscard]] static bool is_finite(const PipingComponent& component) {
    const auto is_number = [](const std::optional<double>& length) {
      return std::isfinite(length.value_or(0));
    };
    return is_number(component.bend_radius) && is_number(component.wall) &&
           component.center.value_or(Vec3::Zero()).allFinite() &&
           std::ranges::all_of(component.ports, [&](const PipingPort& port) {
             return port.center.allFinite() && is_number(port.radius);
           });
  }

  // A bend whose corner lies off the straight line between its ends.
  [[nodiscard]] bool is_turned(const PipingComponent& component) const {
    if (component.shape != PipingShape::bend || !component.center) {
      return false;
    }
    const Vec3 chord = component.ports[1].center - component.ports[0].center;
    const Vec3 to_corner = *component.center - component.ports[0].center;
    const bool has_legs = to_corner.norm() > options_.snap &&
                          (*component.center - component.ports[1].center).norm() > options_.snap;
    return has_legs && chord.cross(to_corner).norm() > options_.snap * chord.norm();
  }

  void pair_up() {
    result_.ports = line_ports(line_, is_left_out_);
    result_.pairs = paired(result_.ports, options_.snap, options_.bridge);
  }

  void refuse_without_radius() {
    infer_radii(line_, result_.pairs, result_.ports, notes_);
    bool is_any = false;
    for (const LinePort& port : result_.ports) {
      const PipingComponent& component = line_.components[port.component];
      if (!port.radius && !is_left_out_[port.component] &&
          !(component.shape == PipingShape::closure && component.ports.size() == 1)) {
        notes_.refuse(component, "it has no bore, and nothing that it is joined to has one");
        is_left_out_[port.component] = is_any = true;
      }
    }
    if (is_any) {
      std::erase_if(result_.ports,
                    [&](const LinePort& port) { return is_left_out_[port.component]; });
      result_.pairs = paired(result_.ports, options_.snap, options_.bridge);
    }
  }

  // The position in `ports` of a component's end; none: it coincides with the fitting's centre.
  [[nodiscard]] std::optional<std::size_t> port(std::size_t component, std::size_t index) const {
    for (std::size_t i = first_port_[component];
         i < result_.ports.size() && result_.ports[i].component == component; ++i) {
      if (result_.ports[i].index == index) {
        return i;
      }
    }
    return std::nullopt;
  }

  void add(std::size_t i) {
    const PipingComponent& component = line_.components[i];
    if (component.shape == PipingShape::fitting) {
      add_fitting(i);
    } else if (component.ports.size() >= 2) {
      if (is_turned(component)) {
        add_bend(component.name, i, {*port(i, 0), *port(i, 1)});
      } else {
        if (component.shape == PipingShape::bend) {
          notes_.add(component,
                     "does not turn, as its centre point, where its legs should meet, lies on the "
                     "line of its ends; a pipe takes its place");
        }
        add_between(component.name, i, *port(i, 0), *port(i, 1));
      }
      for (std::size_t k = 2; k < component.ports.size(); ++k) {
        if (const auto end = port(i, k)) {
          add_arm(component.name + "-branch" + (k > 2 ? std::to_string(k - 1) : ""), i,
                  branch_start(component, k), *end);
        }
      }
    }
  }

  Span& add_span(const std::string& name, std::size_t component) {
    Span span;
    span.name = name;
    span.component = component;
    span.is_solid = line_.components[component].shape == PipingShape::closure;
    span.is_eccentric = line_.components[component].is_eccentric;
    result_.spans.push_back(span);
    return result_.spans.back();
  }

  void set_end(Span& span, std::size_t end, std::size_t port) {
    span.ends[end].point = result_.ports[port].center;
    span.ends[end].port = port;
    span.radii[end] = *result_.ports[port].radius;
    result_.span_of_port[port] = std::array{result_.spans.size() - 1, end};
  }

  void add_between(const std::string& name, std::size_t component, std::size_t from,
                   std::size_t to) {
    Span& span = add_span(name, component);
    set_end(span, 0, from);
    set_end(span, 1, to);
  }

  // From inside of the fitting.
  void add_arm(const std::string& name, std::size_t component, const Vec3& from, std::size_t to) {
    Span& span = add_span(name, component);
    set_end(span, 1, to);
    span.ends[0].point = from;
    span.ends[0].is_hidden = true;
    span.radii[0] = span.radii[1];
  }

  // A leg has the radius of its end.
  void add_bend(const std::string& name, std::size_t component,
                const std::array<std::size_t, 2>& ends) {
    const std::size_t first = result_.spans.size();
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      Span& leg = add_span(name, component);
      leg.role = SpanRole::bend_leg;
      set_end(leg, 0, ends[k]);
      leg.ends[1].point = *line_.components[component].center;
      leg.other_leg = first + 1 - k;
      leg.radii.fill(*result_.ports[ends[k]].radius);
    }
  }

  // On a leg if the branch leads along it, else in the middle of the arc.
  [[nodiscard]] static Vec3 branch_start(const PipingComponent& bend, std::size_t k) {
    const Vec3 &to = bend.ports[k].center,
               corner = bend.center.value_or((bend.ports[0].center + bend.ports[1].center) / 2);
    Vec3 inward = Vec3::Zero();
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      const Vec3 leg = corner - bend.ports[end].center, way = to - bend.ports[end].center;
      if (leg.dot(way) > kAlongLeg * leg.norm() * way.norm()) {
        return bend.ports[end].center + kBranchOnLeg * leg;
      }
      inward -= leg.normalized();
    }
    const double cosine = std::clamp(turn_cosine(bend), -1.0, 1.0);
    const double half = std::acos(cosine) / 2, leg = (corner - bend.ports[0].center).norm();
    const double bend_radius = leg / std::tan(half);
    const Vec3 middle = corner + bend_radius * (1 / std::cos(half) - 1) * inward.normalized();
    return middle.allFinite() ? middle : corner;  // of one that does not turn
  }

  void add_fitting(std::size_t i) {
    const PipingComponent& component = line_.components[i];
    std::vector<std::size_t> arms;
    arms.reserve(component.ports.size());
    for (std::size_t k = 0; k < component.ports.size(); ++k) {
      const auto end = port(i, k);
      if (end && (result_.ports[*end].center - *component.center).norm() > options_.snap) {
        arms.push_back(*end);
      } else {
        notes_.add(component, "its end at line " + std::to_string(component.ports[k].line) +
                                  " lies in its centre; there is no arm to it");
      }
    }
    if (arms.size() < 2) {
      if (!arms.empty()) {
        add_arm(component.name, i, *component.center, arms[0]);
      }
      return;
    }
    const std::vector<std::size_t> all = arms;
    const auto run = take_run(arms);
    if (!run || is_thinner(*run, arms)) {
      add_ball(component, i, all);
      return;
    }
    const std::size_t own = result_.spans.size();
    add_run(component, i, *run);
    const std::size_t first = result_.spans.size();
    const Vec3 beside = foot(*run, *component.center);
    const double radius = *result_.ports[(*run)[0]].radius;
    const bool is_beside = (*component.center - beside).norm() > kBesideRun * radius;
    const auto cross = take_run(arms);
    if (cross) {
      add_between(component.name + "-branch", i, (*cross)[0], (*cross)[1]);
    }
    for (std::size_t k = 0; k < arms.size(); ++k) {
      add_arm(component.name + "-branch" + (k == 0 && !cross ? "" : std::to_string(k + 2)), i,
              is_beside ? beside : abreast(*run, *component.center, arms[k]), arms[k]);
    }
    for (std::size_t k = first; k < result_.spans.size() && first == own + 1; ++k) {
      result_.branches.push_back({own, k});  // the arc of a run that turns has none
    }
  }

  void add_ball(const PipingComponent& component, std::size_t i,
                const std::vector<std::size_t>& arms) {
    const Vec3& center = *component.center;
    double thickest = 0;
    for (const std::size_t arm : arms) {
      thickest = std::max(thickest, *result_.ports[arm].radius);
    }
    const double ball = kBall * thickest;
    for (std::size_t k = 0; k < arms.size(); ++k) {
      const Vec3 leg = result_.ports[arms[k]].center - center;
      const double begin = std::min(kInBall * leg.norm(), kInBallBeyondArm * (ball - thickest));
      add_arm(component.name + "-arm" + std::to_string(k + 1), i, center + begin * leg.normalized(),
              arms[k]);
      if (!partners_[arms[k]] && leg.norm() < ball) {
        notes_.add(component, "its end at line " + std::to_string(result_.ports[arms[k]].line) +
                                  " lies inside of its ball of radius " +
                                  decimal(ball, kMessageDigits) + ", and opens nowhere");
      }
    }
    result_.balls.push_back({component.name, i, center, ball});
  }

  // Takes out the two arms that lie on one line best, if they do or if an arc fits between them.
  std::optional<std::array<std::size_t, 2>> take_run(std::vector<std::size_t>& arms) const {
    std::optional<std::array<std::size_t, 2>> result;
    double best = kRunCosine;
    for (std::size_t k = 0; k < arms.size(); ++k) {
      for (std::size_t l = k + 1; l < arms.size(); ++l) {
        const double cosine = -result_.ports[arms[k]].outward->dot(*result_.ports[arms[l]].outward);
        if (cosine > best && (is_straight_run({arms[k], arms[l]}) || has_arc(arms[k], arms[l]))) {
          best = cosine;
          result = {arms[k], arms[l]};
        }
      }
    }
    if (result) {
      std::erase_if(arms,
                    [&](std::size_t arm) { return arm == (*result)[0] || arm == (*result)[1]; });
    }
    return result;
  }

  // A line, though the centre may lie beside it, or an arc that is tangent to both arms where what
  // is joined to them goes on along these.
  void add_run(const PipingComponent& component, std::size_t i,
               const std::array<std::size_t, 2>& run) {
    if (is_straight_run(run)) {
      add_between(component.name, i, run[0], run[1]);
    } else {
      add_bend(component.name, i, run);
    }
  }

  [[nodiscard]] bool is_straight_run(const std::array<std::size_t, 2>& run) const {
    const LinePort &a = result_.ports[run[0]], &b = result_.ports[run[1]];
    const Vec3& center = *line_.components[a.component].center;
    const Vec3 chord = b.center - a.center;
    if (chord.cross(center - a.center).norm() <= options_.snap * chord.norm()) {
      return true;
    }
    bool goes_on = false;
    for (const std::size_t port : run) {
      const auto& partner = partners_[port];
      const LinePort& own = result_.ports[port];
      const Vec3 along = (port == run[0] ? -1 : 1) * chord.normalized();
      if (partner && result_.ports[*partner].outward) {
        const Vec3& next = *result_.ports[*partner].outward;
        if (next.cross(along).norm() > next.cross(*own.outward).norm()) {
          return false;
        }
        goes_on = true;
      }
    }
    return goes_on || -a.outward->dot(*b.outward) > kAlmostStraight;
  }

  [[nodiscard]] bool has_arc(std::size_t from, std::size_t to) const {
    const LinePort &a = result_.ports[from], &b = result_.ports[to];
    const Vec3& center = *line_.components[a.component].center;
    const double leg = std::min((a.center - center).norm(), (b.center - center).norm());
    const double half = kink(a, b) / 2;
    return leg > kArcOfRun * *a.radius * std::tan(half) && *a.radius == *b.radius &&
           leg * std::tan(half / 2) <= kArcBesideCenter * *a.radius;
  }

  // Whether the mouth of one of these arms would stick out of the run.
  [[nodiscard]] bool is_thinner(const std::array<std::size_t, 2>& run,
                                const std::vector<std::size_t>& arms) const {
    const LinePort &a = result_.ports[run[0]], &b = result_.ports[run[1]];
    const Vec3 there = foot(run, *line_.components[a.component].center);
    const double share = (there - a.center).norm() / (b.center - a.center).norm();
    const double radius = *a.radius + share * (*b.radius - *a.radius);
    return std::ranges::any_of(
        arms, [&](std::size_t arm) { return *result_.ports[arm].radius > radius; });
  }

  // Where the arm from the centre is level with the run's axis: no other place hides the mouth of
  // one that is as thick as the run.
  [[nodiscard]] Vec3 abreast(const std::array<std::size_t, 2>& run, const Vec3& center,
                             std::size_t arm) const {
    const Vec3 &start = result_.ports[run[0]].center,
               along = (result_.ports[run[1]].center - start).normalized(),
               leg = result_.ports[arm].center - center, outward = leg.normalized();
    const double cosine = outward.dot(along);
    if (std::abs(cosine) > kAlongRun) {
      return center;
    }
    const Vec3 offset = center - start;
    const double further =
        (offset.dot(along) * cosine - offset.dot(outward)) / (1 - cosine * cosine);
    return center + std::min(further, leg.norm() / 2) * outward;
  }

  // Of the point, on the line between two ends.
  [[nodiscard]] Vec3 foot(const std::array<std::size_t, 2>& run, const Vec3& point) const {
    const Vec3 &start = result_.ports[run[0]].center, way = result_.ports[run[1]].center - start;
    return start + std::clamp((point - start).dot(way) / way.squaredNorm(), 0.0, 1.0) * way;
  }

  void link() {
    for (std::size_t k = 0; k < result_.pairs.size(); ++k) {
      for (const std::size_t port : {result_.pairs[k].first, result_.pairs[k].second}) {
        if (const auto& place = result_.span_of_port[port]) {
          result_.spans[(*place)[0]].ends[(*place)[1]].joint = k;
        }
      }
    }
  }

  // An eccentric reducer whose ends lie beside each other, in one plane, takes as much of its
  // thicker neighbour as a step would.
  void lengthen_flat_reducer(std::size_t i) {
    Span& own = result_.spans[i];
    const std::size_t thick = own.radii[0] > own.radii[1] ? 0 : 1;
    const auto beside = result_.joined(own.ends[thick]);
    if (!own.is_eccentric || own.radii[0] == own.radii[1] || !beside) {
      return;
    }
    Span& pipe = result_.spans[(*beside)[0]];
    SpanEnd& end = pipe.ends[(*beside)[1]];
    const Vec3 way = end.point - pipe.ends[1 - (*beside)[1]].point;
    const Vec3 across = own.ends[1].point - own.ends[0].point;
    if (pipe.role != SpanRole::straight || pipe.is_solid || pipe.is_eccentric ||
        !(pipe.length() > options_.snap) ||
        !(std::abs(across.dot(way)) <= options_.snap * way.norm())) {
      return;
    }
    const double length =
        std::min(std::max(std::abs(own.radii[0] - own.radii[1]), kFlatReducer * own.radii[thick]),
                 pipe.length() / 2);
    const Vec3 back = length / way.norm() * way;
    end.point -= back;
    own.ends[thick].point -= back;
    notes_.add(line_.components[own.component],
               "has no length along its neighbours' axis; it takes " +
                   decimal(length, kMessageDigits) + " of " + pipe.name);
  }

  const PipingLine& line_;
  const PipingOptions& options_;
  LineNotes& notes_;
  std::vector<bool> is_left_out_, is_short_;
  std::vector<std::size_t> first_port_;
  std::vector<std::optional<std::size_t>> partners_;  // of ports
  PipingSpans result_;
};

}  // namespace

std::optional<std::array<std::size_t, 2>> PipingSpans::joined(const SpanEnd& end) const {
  if (!end.joint) {
    return std::nullopt;
  }
  const PortPair& pair = pairs[*end.joint];
  return span_of_port[pair.first == *end.port ? pair.second : pair.first];
}

PipingSpans spans_of(const PipingLine& line, const PipingOptions& options, LineNotes& notes) {
  return Spans(line, options, notes).run();
}

}  // namespace dupin::network
