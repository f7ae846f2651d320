#include <map>
#include <optional>
#include <utility>

#include "dupin/blends/piping_line.h"
#include "network/line_notes.h"
#include "network/piping_chain.h"
#include "network/piping_spans.h"

namespace dupin {
namespace {

using network::LinePort;

/// Where ends look as the solids made of them do, not from one point of the file to the next: the
/// circles of an eccentric reducer are parallel, and runs of tees go straight from end to end.
class EndDirections {
 public:
  explicit EndDirections(const PipingLine& line) {
    const PipingOptions options{.bridge = network::kMeant, .keep_going = true};
    network::LineNotes notes(line.source, options.keep_going);
    spans_ = spans_of(line, options, notes);
    outward_.resize(spans_.ports.size());
    partner_.resize(spans_.ports.size());
    for (const network::PortPair& pair : spans_.pairs) {
      partner_[pair.first] = pair.second;
      partner_[pair.second] = pair.first;
    }
    take_ways();
    for (const network::Chain& chain : chains_of(spans_, options.snap)) {
      take_offsets(chain);
    }
  }

  struct Found {
    std::optional<Vec3> outward;
    std::optional<double> radius;  ///< also where the file has none
  };
  /// None of an end that nothing is made of.
  [[nodiscard]] std::map<std::pair<std::size_t, std::size_t>, Found> take() const {
    std::map<std::pair<std::size_t, std::size_t>, Found> result;
    for (std::size_t i = 0; i < outward_.size(); ++i) {
      const LinePort& port = spans_.ports[i];
      result.emplace(std::pair(port.component, port.index), Found{outward_[i], port.radius});
    }
    return result;
  }

 private:
  // From the other end of what is made, by the arithmetic of line_ports.
  void take_ways() {
    for (std::size_t i = 0; i < outward_.size(); ++i) {
      if (const auto& place = spans_.span_of_port[i]) {
        const auto& ends = spans_.spans[(*place)[0]].ends;
        const Vec3 way = spans_.ports[i].center - ends[1 - (*place)[1]].point;
        const double length = way.norm();
        outward_[i] = length > 0 ? std::optional<Vec3>(way / length) : spans_.ports[i].outward;
      }
    }
  }

  // Of eccentric parts: what the nearest end looks against that is of none, before or behind.
  void take_offsets(const network::Chain& chain) {
    for (const network::Leg& leg : chain.legs) {
      if (leg.is_offset) {
        outward_[port_of(begin_of(spans_, leg.elements[0]))].reset();
        outward_[port_of(end_of(spans_, leg.elements[0]))].reset();
      }
    }
    for (auto leg = chain.legs.begin(); leg != chain.legs.end(); ++leg) {
      if (leg->is_offset) {
        face_neighbour(begin_of(spans_, leg->elements[0]), end_of(spans_, leg->elements[0]));
      }
    }
    for (auto leg = chain.legs.rbegin(); leg != chain.legs.rend(); ++leg) {
      if (leg->is_offset) {
        face_neighbour(end_of(spans_, leg->elements[0]), begin_of(spans_, leg->elements[0]));
      }
    }
  }

  void face_neighbour(const network::SpanEnd& near, const network::SpanEnd& far) {
    const std::size_t own = port_of(near), other = port_of(far);
    const std::optional<std::size_t> partner = partner_[own];
    if (!outward_[own] && partner && outward_[*partner]) {
      outward_[own] = -*outward_[*partner];
      outward_[other] = *outward_[*partner];
    }
  }

  // Ends of eccentric parts are ends of their components.
  [[nodiscard]] static std::size_t port_of(const network::SpanEnd& end) { return end.port.value(); }

  network::PipingSpans spans_;
  std::vector<std::optional<Vec3>> outward_;         // of ports
  std::vector<std::optional<std::size_t>> partner_;  // the same
};

}  // namespace

std::vector<Port> ports(const PipingLine& line) {
  const std::vector<bool> all(line.components.size(), false);
  const auto directions = EndDirections(line).take();
  std::vector<Port> result;
  for (const LinePort& port : network::line_ports(line, all)) {
    const PipingComponent& component = line.components[port.component];
    const auto found = directions.find({port.component, port.index});
    const bool is_made = found != directions.end();
    const auto outward = is_made && found->second.outward ? found->second.outward : port.outward;
    const auto radius = is_made ? found->second.radius : port.radius;
    if (outward && radius) {
      result.push_back({component.name + "." + std::to_string(port.index + 1),
                        {port.center, *outward, *radius},
                        component.name});
    }
  }
  return result;
}

}  // namespace dupin
