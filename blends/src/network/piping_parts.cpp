#include "network/piping_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "dupin/blends/cyclic_blend.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "network/piping_fillets.h"
#include "numbers/angle.h"
#include "ringed/arc_velocities.h"

namespace dupin::network {
namespace {

// Of a pipe, what a blend at one of its ends may take.
constexpr double kRoom = 0.45;
// How far a blend's ends are set back, by the radius, the kink and the gap; then in steps.
constexpr double kSetbackOfRadius = 0.5, kSetbackOfKink = 3, kSetbackOfGap = 3;
// Where speeds of an arc leave this margin, no others are looked for; those that are found keep
// their margin when the ends are rounded once more.
constexpr double kEasyMargin = 0.3, kSafeMargin = 0.0501;
constexpr double kLargerSetbacks[] = {1, 1.6, 2.5, 4, 6.3};

void put(PipingNetwork& network, Part part, const PipingComponent& origin) {
  part.component = {origin.name, origin.kind, origin.line};
  network.assembly.parts.push_back(std::move(part));
  network.origins.push_back(origin.name);
}

// What is seen of an end that is none of the line is part of the wall. Of one inside of a part as
// thick as its own, that is what the meshes' distance from the surfaces leaves outside.
void hide(PipingNetwork& network, const PortReference& end) {
  network.assembly.patches[to_string(end)] = end.part;
}

// Of a chain, and where it lies.
struct ChainEnd {
  PortReference reference;
  Vec3 place;
};

// Writes one chain's parts.
class ChainParts {
 public:
  ChainParts(const PipingLine& line, const PipingOptions& options, const PipingSpans& spans,
             const Chain& chain, PipingNetwork& network, LineNotes& notes)
      : line_(line),
        spans_(spans),
        chain_(chain),
        network_(network),
        notes_(notes),
        snap_(options.snap),
        plan_(plan(line, options, spans, chain, network.joints, notes)) {}

  // Whether a blend may take a bend's place, which is noted, or refused if none fits.
  [[nodiscard]] bool replaces_bends() const {
    return std::ranges::any_of(chain_.seams,
                               [](const Seam& seam) { return seam.component.has_value(); });
  }

  // Makes room for them.
  void make_blends() {
    for (std::size_t k = 1; k < chain_.legs.size(); ++k) {
      if (is_blended(chain_.seams[k].kind)) {
        if (auto made = blend(k)) {
          blends_.push_back(std::move(*made));
        }
      }
    }
  }

  [[nodiscard]] PlannedChain planned() { return {&chain_, &plan_}; }

  void write(std::map<std::size_t, ChainEnd>& made) {
    for (std::size_t k = 0; k < chain_.legs.size(); ++k) {
      const SeamKind before = chain_.seams[k].kind;
      if (before == SeamKind::corner && !plan_.arcs[k]->is_left_out) {
        add_elbow(k);
      } else if (before != SeamKind::offset) {
        port_.reset();
      }
      for (std::size_t i = 0; i < plan_.stretches[k].size(); ++i) {
        const bool is_last = k + 1 == chain_.legs.size() && i + 1 == plan_.stretches[k].size();
        if (is_last && chain_.is_closed && !port_ && first_) {
          add_last_stretch(k, plan_.stretches[k][i]);
        } else {
          add_stretch(k, plan_.stretches[k][i], is_last);
        }
      }
    }
    for (auto& [part, component] : blends_) {
      put(network_, std::move(part), line_.components[component]);
    }
    settle_joints();
    note_ends(made);
    measure_moves();
  }

 private:
  void add(std::string name, std::size_t component, PartShape shape, bool is_solid = false) {
    if (!first_) {
      first_ = PortReference{name, End::start};
    }
    port_ = PortReference{name, End::end};
    Part part{std::move(name), std::move(shape)};
    part.solid = is_solid;
    if (!is_solid) {  // of a solid one it says how thick the pipe beside it is
      part.wall = line_.components[component].wall;
    }
    put(network_, std::move(part), line_.components[component]);
  }

  // A chain that begins anew with its last stretch has half of that to be closed by.
  void add_last_stretch(std::size_t k, const Stretch& stretch) {
    Stretch half = stretch, rest = stretch;
    half.levels[1] = rest.levels[0] = (stretch.levels[0] + stretch.levels[1]) / 2;
    half.radii[1] = rest.radii[0] = (stretch.radii[0] + stretch.radii[1]) / 2;
    rest.name += "-end";
    add_stretch(k, half, false);
    add_stretch(k, rest, true);
  }

  void add_stretch(std::size_t k, const Stretch& stretch, bool is_last) {
    const Leg& leg = chain_.legs[k];
    const Vec3 to = point_at(leg, stretch.levels[1]);
    const bool goes_on = port_.has_value();
    note_reducer(leg, stretch);
    PartShape shape;
    if (closes_chain(k) && is_last) {
      shape = CyclicBlendBetween{*port_, *first_, {}};
      closing_ = stretch.name;
    } else if (leg.is_offset) {
      const auto& [start, there] = leg.circles;
      note_move(begin_of(spans_, leg.elements[0]).point, goes_on ? here_ : start);
      note_move(end_of(spans_, leg.elements[0]).point, there);
      shape = goes_on ? PartShape(ObliqueTo{*port_, there, stretch.radii[1]})
                      : PartShape(ObliqueBetween{start, there, leg.direction, stretch.radii[0],
                                                 stretch.radii[1]});
    } else if (!goes_on) {
      shape = shape_of(leg, stretch);
    } else if (stretch.radii[0] != stretch.radii[1]) {
      const double length = (to - here_).dot(leg.direction);
      shape = ConeAlong{*port_, length, stretch.radii[1], {}, {}};
    } else {
      shape = PipeTo{*port_, to};
    }
    add(stretch.name, stretch.component, std::move(shape), stretch.is_solid);
    here_ = leg.is_offset ? leg.circles[1] : to;
    radius_ = stretch.radii[1];
  }

  // Where it does not become what its name says.
  void note_reducer(const Leg& leg, const Stretch& stretch) {
    const PipingComponent& component = line_.components[stretch.component];
    if (!component.is_eccentric || stretch.name != component.name) {
      return;
    }
    const Span& span = spans_.spans[leg.elements.front().span];
    const bool has_one_bore = stretch.span && spans_.spans[*stretch.span].radii[0] ==
                                                  spans_.spans[*stretch.span].radii[1];
    if (has_one_bore && leg.is_offset) {
      const Vec3 across = (span.ends[1].point - span.ends[0].point).cross(leg.direction);
      notes_.add(component, "has the same bore at both ends, " +
                                decimal(across.norm(), kMessageDigits) +
                                " beside each other; a slanted pipe takes its place");
    } else if (has_one_bore) {
      notes_.add(component, "has the same bore at both ends; a pipe takes its place");
    } else if (!component.kind.ends_with("CONCENTRIC") && !leg.is_offset &&
               stretch.radii[0] != stretch.radii[1]) {
      notes_.add(component,
                 "has no flat side, as its neighbours do not lie beside each other; a concentric "
                 "cone takes its place");
    }
  }

  // Whether the last part of this leg closes a chain.
  [[nodiscard]] bool closes_chain(std::size_t k) const {
    return chain_.is_closed && k + 1 == chain_.legs.size() && port_ && first_;
  }

  void add_elbow(std::size_t k) {
    const Arc& arc = *plan_.arcs[k];
    const Leg &in = chain_.legs[k - 1], &out = chain_.legs[k];
    const Vec3 corner = point_at(in, in.nodes.back());
    const double tangent = port_ ? (corner - here_).dot(in.direction) : arc.tangent;
    const Vec3 to = corner + tangent * out.direction;
    const std::string& name = line_.components[arc.component].name;
    if (closes_chain(k) && plan_.stretches[k].empty()) {
      add(name, arc.component, CyclicBlendBetween{*port_, *first_, {}});
      closing_ = name;
    } else if (port_) {
      if (radius_ != arc.radius) {
        notes_.add(line_.components[arc.component],
                   "continues with its neighbour's radius, as there is no room for a step");
      }
      add(name, arc.component, ElbowCorner{*port_, corner, to});
    } else {
      const Vec3 from = corner - tangent * in.direction;
      add(name, arc.component, ElbowCorner{Place{from, corner - from, arc.radius, {}}, corner, to});
      radius_ = arc.radius;
    }
    here_ = to;
  }

  // Between the last stretch of one leg and the first of the next, which it shortens, and the
  // component that it stands for; none if none fits.
  std::optional<std::pair<Part, std::size_t>> blend(std::size_t k) {
    const Seam& seam = chain_.seams[k];
    auto &before = plan_.stretches[k - 1], &after = plan_.stretches[k];
    if (!before.empty() && !after.empty()) {
      const Stretch last = before.back(), first = after.front();
      for (const auto& setbacks : setback_choices(k)) {
        before.back() = shortened(last, 1, setbacks[0]);
        after.front() = shortened(first, 0, setbacks[1]);
        if (const auto speeds =
                speeds_of(chain_.legs[k - 1], before.back(), chain_.legs[k], after.front())) {
          return std::pair(joined_by_blend(seam, before.back(), after.front(), *speeds),
                           seam.component.value_or(before.back().component));
        }
      }
      before.back() = last;
      after.front() = first;
    }
    if (seam.component) {
      notes_.refuse(line_.components[*seam.component],
                    "it is not tangent to its neighbours, and no blend fits between them",
                    Errc::infeasible_blend);
    }
    for (const auto& joint : seam.joints) {
      if (joint) {
        network_.joints[*joint].state = JointState::apart;
      }
    }
    return std::nullopt;
  }

  // The stretch without the last piece of it at that end; a cone keeps its slope.
  [[nodiscard]] static Stretch shortened(Stretch stretch, std::size_t end, double by) {
    const double share = by / stretch.length();
    stretch.radii[end] += share * (stretch.radii[1 - end] - stretch.radii[end]);
    stretch.levels[end] += end == 0 ? by : -by;
    return stretch;
  }

  [[nodiscard]] std::vector<std::array<double, 2>> setback_choices(std::size_t k) const {
    const Stretch &before = plan_.stretches[k - 1].back(), &after = plan_.stretches[k].front();
    const Leg &in = chain_.legs[k - 1], &out = chain_.legs[k];
    const double radius = std::max(before.radii[1], after.radii[0]);
    const double gap = (point_at(out, after.levels[0]) - point_at(in, before.levels[1])).norm();
    const double kink = numbers::angle_between(in.direction, out.direction);
    const bool is_bend = chain_.seams[k].kind == SeamKind::bend;
    const double least =
        std::max({kSetbackOfRadius * radius, kSetbackOfKink * radius * std::tan(kink / 4),
                  is_bend ? 0 : kSetbackOfGap * gap});
    std::vector<std::array<double, 2>> result;
    if (is_bend) {
      result.push_back({0, 0});
    }
    for (const double factor : kLargerSetbacks) {
      result.push_back({std::min(factor * least, kRoom * before.length()),
                        std::min(factor * least, kRoom * after.length())});
    }
    return result;
  }

  // Of the blend between both; none if none fits. The document keeps them, so that no build has to
  // look for them again.
  [[nodiscard]] static std::optional<CyclicBlendOptions> speeds_of(const Leg& in,
                                                                   const Stretch& before,
                                                                   const Leg& out,
                                                                   const Stretch& after) {
    const auto slope = [](const Stretch& stretch) {
      return (stretch.radii[1] - stretch.radii[0]) / stretch.length();
    };
    const Ring from{point_at(in, before.levels[1]), in.direction, before.radii[1], slope(before)};
    const Ring to{point_at(out, after.levels[0]), Vec3::Zero() - out.direction, after.radii[0],
                  -slope(after)};
    const Vec3 chord = to.center - from.center;
    if (!(chord.dot(from.normal) > 0 && chord.dot(to.normal) < 0)) {
      return std::nullopt;  // the ends lie behind each other
    }
    try {
      if (const auto arc = ringed::arc_velocities(from, to, kEasyMargin)) {
        return arc;
      }
      const BlendChoice choice = choose_velocities(from, to, {.margin = kSafeMargin});
      return CyclicBlendOptions{.k = choice.k, .l = choice.l};
    } catch (const Error&) {
      return std::nullopt;
    }
  }

  Part joined_by_blend(const Seam& seam, const Stretch& before, const Stretch& after,
                       const CyclicBlendOptions& speeds) {
    Part part{{}, CyclicBlendBetween{{before.name, End::end}, {after.name, End::start}, speeds}};
    if (seam.component) {
      part.name = line_.components[*seam.component].name;
      notes_.add(line_.components[*seam.component],
                 why_blended(seam) + "; a blend between them takes its place");
      part.wall = line_.components[*seam.component].wall;
    } else {
      const PipingJoint& joint = network_.joints[*seam.joints[0]];
      part.name = std::string(seam.kind == SeamKind::bridge ? "bridge-" : "blend-") +
                  std::to_string(joint.lines[0]) + "-" + std::to_string(joint.lines[1]);
      part.wall = line_.components[before.component].wall;
    }
    for (const auto& position : seam.joints) {
      if (position) {
        PipingJoint& joint = network_.joints[*position];
        joint.state = joint.distance > snap_ ? JointState::bridged : JointState::blended;
        joint.part = part.name;
      }
    }
    return part;
  }

  // Of a bend.
  [[nodiscard]] std::string why_blended(const Seam& seam) const {
    const bool is_missed = std::ranges::any_of(seam.joints, [this](const auto& position) {
      return position && network_.joints[*position].distance > snap_;
    });
    return has_two_bores(*seam.component) ? "has two bores"
           : is_missed                    ? "lies apart from its neighbours"
                                          : "is not tangent to its neighbours";
  }

  [[nodiscard]] bool has_two_bores(std::size_t component) const {
    const auto& ports = line_.components[component].ports;
    return ports.size() > 1 && ports[0].radius && ports[1].radius &&
           *ports[0].radius != *ports[1].radius;
  }

  // Of the chain's first end.
  [[nodiscard]] Vec3 first_place(const SpanEnd& begin) const {
    const auto& place = plan_.places.front().front();
    const Leg& leg = chain_.legs.front();
    return leg.is_offset ? leg.circles[0] : place ? point_at(leg, (*place)[0]) : begin.point;
  }

  // Which ports of the file are the chain's ends.
  void note_ends(std::map<std::size_t, ChainEnd>& made) const {
    const auto &begin = begin_of(spans_, chain_.legs.front().elements.front()),
               &end = end_of(spans_, chain_.legs.back().elements.back());
    if (begin.port && first_) {
      made[*begin.port] = {*first_, first_place(begin)};
    }
    if (end.port && port_) {
      made[*end.port] = {*port_, here_};
    }
    if (first_ && is_no_end(chain_.legs.front().elements.front(), begin)) {
      hide(network_, *first_);
    }
    if (port_ && is_no_end(chain_.legs.back().elements.back(), end)) {
      hide(network_, *port_);
    }
  }

  // Inside of another part, or the face of what closes the line.
  [[nodiscard]] bool is_no_end(const ChainElement& element, const SpanEnd& end) const {
    return end.is_hidden || (spans_.spans[element.span].is_solid && !end.joint);
  }

  // What shares a ring has met, if no part of its own was made of it.
  void settle_joints() {
    for (std::size_t k = 0; k < chain_.legs.size(); ++k) {
      const Leg& leg = chain_.legs[k];
      const std::size_t first = k > 0 && chain_.seams[k].kind == SeamKind::offset ? 0 : 1;
      for (std::size_t i = first; i < leg.elements.size(); ++i) {
        const bool is_made =
            !(i <= 1 && is_left_out(k)) && !(i + 1 == leg.elements.size() && is_left_out(k + 1));
        const auto& joint = begin_of(spans_, leg.elements[i]).joint;
        if (joint && is_made) {
          settle(*joint, JointState::apart, {});
        }
      }
    }
    if (closing_) {
      settle(*end_of(spans_, chain_.legs.back().elements.back()).joint, JointState::bridged,
             *closing_);
    }
  }

  // `beyond` is its state if the ends do not lie within the snap tolerance.
  void settle(std::size_t position, JointState beyond, const std::string& part) {
    PipingJoint& joint = network_.joints[position];
    if (joint.state == JointState::apart) {
      joint.state = joint.distance > snap_ ? beyond : JointState::met;
      joint.part = joint.state == JointState::bridged ? part : "";
    }
  }

  // Whether the bend before this leg is.
  [[nodiscard]] bool is_left_out(std::size_t k) const {
    return plan_.arcs[k] && plan_.arcs[k]->is_left_out;
  }

  [[nodiscard]] bool is_bridged(const SpanEnd& end) const {
    return end.joint && spans_.pairs[*end.joint].distance > snap_;
  }

  void note_move(const Vec3& from, const Vec3& to) {
    network_.largest_move = std::max(network_.largest_move, (to - from).norm());
  }

  // Of all but eccentric parts. What ends at a bend ends where its arc does.
  void measure_moves() {
    for (std::size_t k = 0; k < chain_.legs.size(); ++k) {
      const Leg& leg = chain_.legs[k];
      for (std::size_t i = 0; i < leg.elements.size() && !leg.is_offset; ++i) {
        if (const auto& place = plan_.places[k][i]) {
          note_move(begin_of(spans_, leg.elements[i]).point, point_at(leg, (*place)[0]));
          const SpanEnd& end = end_of(spans_, leg.elements[i]);
          const bool closes = closing_ && k + 1 == chain_.legs.size() &&
                              i + 1 == leg.elements.size() && !is_bridged(end);
          note_move(end.point, closes ? first_place(end) : point_at(leg, (*place)[1]));
        }
      }
    }
  }

  const PipingLine& line_;
  const PipingSpans& spans_;
  const Chain& chain_;
  PipingNetwork& network_;
  LineNotes& notes_;
  double snap_;
  ChainPlan plan_;
  std::vector<std::pair<Part, std::size_t>> blends_;  // with the component that they stand for
  std::optional<std::string> closing_;                // the part that closes the chain
  std::optional<PortReference> port_, first_;  // where the next part goes on, and the chain's first
  Vec3 here_ = Vec3::Zero();                   // of `port_`
  double radius_ = 0;
};

// What a line ends with that has one point: a plate as thick as the wall where there is one, else
// the end's name.
void add_plates(const PipingLine& line, const PipingOptions& options, const PipingSpans& spans,
                const std::map<std::size_t, ChainEnd>& made, PipingNetwork& network,
                LineNotes& notes) {
  for (const PortPair& pair : spans.pairs) {
    for (const auto& [own, other] :
         {std::pair(pair.first, pair.second), std::pair(pair.second, pair.first)}) {
      const PipingComponent& component = line.components[spans.ports[own].component];
      const auto at = made.find(other);
      if (component.shape != PipingShape::closure || component.ports.size() != 1) {
        continue;
      }
      if (at == made.end()) {
        notes.refuse(component, "it closes no end of a pipe");
        continue;
      }
      const PipingComponent& closed = line.components[spans.ports[other].component];
      const auto wall = component.wall ? component.wall : closed.wall ? closed.wall : options.wall;
      const auto& [reference, place] = at->second;
      network.largest_move =
          std::max(network.largest_move, (component.ports[0].center - place).norm());
      Part part{component.name, CapAt{reference}};
      if (wall && *wall > 0) {
        part.shape = PipeAlong{reference, *wall};
        part.solid = true;
        hide(network, {part.name, End::end});
      }
      put(network, std::move(part), component);
      network.joints[std::size_t(&pair - spans.pairs.data())].state = JointState::met;
    }
  }
}

}  // namespace

void add_parts(const PipingLine& line, const PipingOptions& options, const PipingSpans& spans,
               const std::vector<Chain>& chains, PipingNetwork& network, LineNotes& notes) {
  std::map<std::size_t, ChainEnd> made;
  std::vector<ChainParts> parts;
  parts.reserve(chains.size());
  for (const Chain& chain : chains) {
    tell(options.progress, "join", double(parts.size()) / double(chains.size()));
    parts.emplace_back(line, options, spans, chain, network, notes);
    if (options.blends_kinks || parts.back().replaces_bends()) {
      parts.back().make_blends();
    }
  }
  std::vector<PlannedChain> planned;
  planned.reserve(parts.size());
  for (ChainParts& chain : parts) {
    planned.push_back(chain.planned());
  }
  auto made_fillets = fillets(line, options, spans, planned, notes);
  for (ChainParts& chain : parts) {
    chain.write(made);
  }
  for (const FittingBall& ball : spans.balls) {
    Part part{ball.name, SphereAt{ball.center, ball.radius}};
    part.wall = line.components[ball.component].wall;
    put(network, std::move(part), line.components[ball.component]);
  }
  for (auto& [part, component] : made_fillets) {
    put(network, std::move(part), line.components[component]);
    network.origins.back() = network.assembly.parts.back().name;  // alone, if it is refused
  }
  add_plates(line, options, spans, made, network, notes);
}

}  // namespace dupin::network
