#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "dupin/blends/piping_line.h"
#include "dupin/kernel/error.h"
#include "network/line_notes.h"
#include "network/piping_chain.h"
#include "network/piping_parts.h"
#include "network/piping_radii.h"
#include "network/piping_reach.h"
#include "network/piping_spans.h"

namespace dupin {
namespace {

void check_option(double value, const std::string& what) {
  if (!(std::isfinite(value) && value >= 0)) {
    throw Error(Errc::invalid_argument, "must be a length of at least 0", {}, what);
  }
}

// Of a fitting, so near to its centre that there is no arm to it.
bool is_in_center(const PipingLine& line, const network::PipingSpans& spans, std::size_t port) {
  return !spans.span_of_port[port] &&
         line.components[spans.ports[port].component].shape == PipingShape::fitting;
}

std::vector<PipingJoint> joints_of(const PipingLine& line, const network::PipingSpans& spans,
                                   const std::vector<network::PortPair>& pairs) {
  std::vector<PipingJoint> joints;
  joints.reserve(pairs.size());
  for (const network::PortPair& pair : pairs) {
    const network::LinePort &a = spans.ports[pair.first], &b = spans.ports[pair.second];
    PipingJoint joint;
    joint.components = {line.components[a.component].name, line.components[b.component].name};
    joint.lines = {a.line, b.line};
    joint.distance = pair.distance;
    joint.step = a.radius && b.radius ? std::abs(*a.radius - *b.radius) : 0;
    joint.kink = network::kink(a, b);
    // Until a part is made of it; but what ends in a fitting's centre ends in its body.
    const bool is_in_fitting =
        is_in_center(line, spans, pair.first) || is_in_center(line, spans, pair.second);
    joint.state = is_in_fitting ? JointState::met : JointState::apart;
    joints.push_back(joint);
  }
  return joints;
}

// Ends that are meant to meet, and do not: nothing is made of them, but they are said.
std::vector<network::PortPair> misfits(const PipingLine& line, const network::PipingSpans& spans,
                                       const PipingOptions& options) {
  std::vector<bool> is_taken(spans.ports.size());
  for (const network::PortPair& pair : spans.pairs) {
    is_taken[pair.first] = is_taken[pair.second] = true;
  }
  std::vector<network::LinePort> free;
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < spans.ports.size(); ++i) {
    const auto& place = spans.span_of_port[i];
    const bool is_in_run = place && spans.spans[(*place)[0]].ends[(*place)[1]].is_in_run;
    if (!is_taken[i] && !is_in_run && !is_in_center(line, spans, i)) {
      free.push_back(spans.ports[i]);
      positions.push_back(i);
    }
  }
  std::vector<network::PortPair> result = network::paired(free, options.snap, network::kMeant);
  for (network::PortPair& pair : result) {
    pair.first = positions[pair.first];
    pair.second = positions[pair.second];
  }
  return result;
}

void add_misfits(std::vector<PipingJoint> missed, PipingNetwork& network) {
  const auto met = static_cast<std::ptrdiff_t>(network.joints.size());
  network.joints.insert(network.joints.end(), std::make_move_iterator(missed.begin()),
                        std::make_move_iterator(missed.end()));
  std::ranges::inplace_merge(network.joints, network.joints.begin() + met, {},
                             [](const PipingJoint& joint) { return joint.lines; });
}

std::size_t count_open(const network::PipingSpans& spans,
                       const std::vector<network::PortPair>& missed) {
  std::vector<bool> is_missed(spans.ports.size());
  for (const network::PortPair& pair : missed) {
    is_missed[pair.first] = is_missed[pair.second] = true;
  }
  std::size_t count = 0;
  for (const network::Span& span : spans.spans) {
    for (const network::SpanEnd& end : span.ends) {
      const bool is_end =
          end.port ? !end.joint && !is_missed[*end.port] : span.role == network::SpanRole::straight;
      count += is_end && !end.is_hidden && !span.is_solid;
    }
  }
  return count;
}

// With the first of the reasons, which are lost otherwise.
[[noreturn]] void refuse_nothing_left(const PipingLine& line,
                                      const std::vector<SourceNote>& notes) {
  const std::string message = "no component is left of which a part could be made";
  if (notes.empty()) {
    throw Error(Errc::invalid_argument, message, {}, line.source);
  }
  const SourceNote& first = notes.front();
  throw Error(Errc::invalid_argument,
              message + ": " + first.text +
                  (notes.size() > 1 ? ", and " + std::to_string(notes.size() - 1) + " more" : ""),
              {}, first.line > 0 ? line.source + ":" + std::to_string(first.line) : line.source);
}

}  // namespace

std::string_view name(JointState state) {
  switch (state) {
    case JointState::met:
      return "met";
    case JointState::stepped:
      return "stepped";
    case JointState::blended:
      return "blended";
    case JointState::bridged:
      return "bridged";
    case JointState::apart:
      break;
  }
  return "apart";
}

PipingNetwork assembly_of(const PipingLine& given, const PipingOptions& options) {
  check_option(options.snap, "snap");
  check_option(options.bridge, "bridge");
  check_option(options.tolerance, "tolerance");
  check_option(options.fillet.value_or(0), "fillet");
  check_option(options.wall.value_or(0), "wall");
  check_option(options.insulation.value_or(0), "insulation");
  network::LineNotes notes(given.source, options.keep_going);
  PipingLine line = given;
  if (!options.wall && std::ranges::any_of(line.components, [](const PipingComponent& component) {
        return component.wall.has_value();
      })) {
    const auto ends = network::line_ports(line, std::vector<bool>(line.components.size(), false));
    network::infer_walls(network::paired(ends, options.snap, options.bridge), ends, line, notes);
  }
  network::PipingSpans spans = spans_of(line, options, notes);
  reach_runs(line, options, spans, notes);
  PipingNetwork result;
  result.joints = joints_of(line, spans, spans.pairs);
  const std::vector<network::PortPair> missed = misfits(line, spans, options);
  result.open_ends = count_open(spans, missed);
  result.assembly.source = line.source;
  result.assembly.is_of_network = true;
  result.assembly.tolerance = options.tolerance;
  result.assembly.wall = options.wall;
  result.assembly.wall_side = options.wall_side;
  result.assembly.insulation = options.insulation;
  const std::vector<network::Chain> chains = chains_of(spans, options.snap);
  add_parts(line, options, spans, chains, result, notes);
  add_misfits(joints_of(line, spans, missed), result);
  result.notes = std::move(notes).take();
  result.notes.insert(result.notes.begin(), line.notes.begin(), line.notes.end());
  std::ranges::stable_sort(result.notes, {}, &SourceNote::line);
  std::set<std::size_t> components;
  for (const network::LinePort& port : spans.ports) {
    components.insert(port.component);
  }
  result.components = components.size();
  if (result.assembly.parts.empty()) {
    refuse_nothing_left(line, result.notes);
  }
  return result;
}

}  // namespace dupin
