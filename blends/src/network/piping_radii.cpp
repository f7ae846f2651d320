#include "network/piping_radii.h"

#include <algorithm>

#include "dupin/kernel/decimal.h"

namespace dupin::network {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

class Radii {
 public:
  Radii(const PipingLine& line, const std::vector<PortPair>& pairs, std::vector<LinePort>& ports)
      : ports_(ports), partner_(ports.size(), kNone), of_component_(line.components.size()) {
    for (const PortPair& pair : pairs) {
      partner_[pair.first] = pair.second;
      partner_[pair.second] = pair.first;
    }
    for (std::size_t i = 0; i < ports.size(); ++i) {
      of_component_[ports[i].component].push_back(i);
    }
  }

  void run() {
    std::vector<std::size_t> known;
    known.reserve(ports_.size());
    for (std::size_t i = 0; i < ports_.size(); ++i) {
      if (ports_[i].radius) {
        known.push_back(i);
      }
    }
    while (!known.empty()) {
      spread(known);
      known = given_by_siblings();
    }
  }

 private:
  void give(std::size_t to, double radius, std::vector<std::size_t>& known) {
    if (!ports_[to].radius) {
      ports_[to].radius = radius;
      known.push_back(to);
    }
  }

  // Over joints, and through components with two ends.
  void spread(std::vector<std::size_t>& known) {
    while (!known.empty()) {
      const std::size_t from = known.back();
      known.pop_back();
      const double radius = *ports_[from].radius;
      if (partner_[from] != kNone) {
        give(partner_[from], radius, known);
      }
      const auto& siblings = of_component_[ports_[from].component];
      if (siblings.size() == 2) {
        give(siblings[0] == from ? siblings[1] : siblings[0], radius, known);
      }
    }
  }

  // To the other ends of fittings, where nothing else gives them one.
  std::vector<std::size_t> given_by_siblings() {
    std::vector<std::size_t> known;
    for (const auto& siblings : of_component_) {
      const auto first = std::ranges::find_if(
          siblings, [&](std::size_t i) { return ports_[i].radius.has_value(); });
      for (const std::size_t i : siblings) {
        if (first != siblings.end()) {
          give(i, *ports_[*first].radius, known);
        }
      }
    }
    return known;
  }

  std::vector<LinePort>& ports_;
  std::vector<std::size_t> partner_;
  std::vector<std::vector<std::size_t>> of_component_;
};

}  // namespace

void infer_walls(const std::vector<PortPair>& pairs, const std::vector<LinePort>& ports,
                 PipingLine& line, LineNotes& notes) {
  std::vector<std::vector<std::size_t>> joined(line.components.size());
  for (const PortPair& pair : pairs) {
    const std::size_t a = ports[pair.first].component, b = ports[pair.second].component;
    joined[a].push_back(b);
    joined[b].push_back(a);
  }
  std::vector<std::size_t> known;  // in the order in which walls spread: the nearest first
  known.reserve(line.components.size());
  std::vector<bool> had_wall(line.components.size());
  for (std::size_t i = 0; i < line.components.size(); ++i) {
    had_wall[i] = line.components[i].wall.has_value();
    if (had_wall[i]) {
      known.push_back(i);
    }
  }
  for (std::size_t k = 0; k < known.size(); ++k) {
    for (const std::size_t other : joined[known[k]]) {
      if (!line.components[other].wall) {
        line.components[other].wall = line.components[known[k]].wall;
        known.push_back(other);
      }
    }
  }
  // What is solid from end to end has none.
  std::erase_if(known, [&](std::size_t i) {
    const PipingComponent& component = line.components[i];
    return had_wall[i] || (component.shape == PipingShape::closure && component.ports.size() == 2);
  });
  if (!known.empty()) {
    notes.add(line.components[*std::ranges::min_element(known)],
              "has no wall of its own" +
                  (known.size() > 1 ? ", as " + std::to_string(known.size() - 1) +
                                          " other component" + (known.size() > 2 ? "s" : "")
                                    : std::string()) +
                  "; those of their neighbours are taken");
  }
}

void infer_radii(const PipingLine& line, const std::vector<PortPair>& pairs,
                 std::vector<LinePort>& ports, LineNotes& notes) {
  std::vector<bool> was_known(ports.size());
  for (std::size_t i = 0; i < ports.size(); ++i) {
    was_known[i] = ports[i].radius.has_value();
  }
  Radii(line, pairs, ports).run();
  std::vector<bool> has_neighbour(line.components.size());
  for (const PortPair& pair : pairs) {
    has_neighbour[ports[pair.first].component] = true;
    has_neighbour[ports[pair.second].component] = true;
  }
  for (std::size_t i = 0; i < ports.size(); ++i) {
    const bool is_first = i == 0 || ports[i - 1].component != ports[i].component;
    const bool is_said = !is_first && !was_known[i - 1];
    if (!was_known[i] && ports[i].radius && !is_said) {
      const std::string radius = decimal(*ports[i].radius, kMessageDigits);
      notes.add(line.components[ports[i].component],
                "has no bore at line " + std::to_string(ports[i].line) +
                    (has_neighbour[ports[i].component]
                         ? "; its neighbours' radius " + radius
                         : "; the radius of another of its ends, " + radius + ",") +
                    " is taken");
    }
  }
}

}  // namespace dupin::network
