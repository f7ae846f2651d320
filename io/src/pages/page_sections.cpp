#include "pages/page_sections.h"

#include <algorithm>
#include <map>
#include <utility>

#include "dupin/kernel/decimal.h"

namespace dupin::pages {
namespace {

constexpr std::size_t kMostWelded = 1000;
constexpr std::uint32_t kOutlineSides = 48;

bool is_length(Deviation::Kind kind) {
  return kind == Deviation::Kind::axial || kind == Deviation::Kind::radius ||
         kind == Deviation::Kind::across || kind == Deviation::Kind::offset;
}

std::string deviation_text(const Deviation& deviation, const std::string& unit) {
  const bool is_angle =
      deviation.kind == Deviation::Kind::kink || deviation.kind == Deviation::Kind::turn;
  return std::string(name(deviation.kind)) + " " +
         measure((deviation.size.lower + deviation.size.upper) / 2, is_length(deviation.kind) ? unit
                                                                    : is_angle ? "rad"
                                                                               : "");
}

bool is_finding(GapVerdict verdict) {
  return verdict != GapVerdict::welded && verdict != GapVerdict::open;
}

PageRow gap_row(const GapPair& pair, const std::vector<Port>& ports, const std::string& unit) {
  const GapVerdict verdict = pair.report.verdict;
  const Port& from = ports.at(pair.first);
  PageRow row{{std::string(name(verdict)), from.name, "", ""}, is_finding(verdict)};
  row.place = PagePlace{from.ring.center, largest_radius(from.ring), {outline(from.ring)}};
  row.place->is_marked = verdict != GapVerdict::welded;
  if (pair.second) {
    const Port& to = ports.at(*pair.second);
    row.cells[2] = to.name;
    row.place->at = (from.ring.center + to.ring.center) / 2;
    row.place->size = std::max(row.place->size, largest_radius(to.ring));
    row.place->lines.push_back(outline(to.ring));
  }
  for (const Deviation& deviation : pair.report.deviations) {
    row.cells[3] += (row.cells[3].empty() ? "" : ", ") + deviation_text(deviation, unit);
  }
  return row;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + (name.empty() ? "(no name)" : name);
  }
  return text;
}

PagePlace marked(const Vec3& at, double size) {
  PagePlace place{at, size};
  place.is_marked = true;
  return place;
}

PagePlace place_of(const PipingComponent& component) {
  std::vector<Vec3> line;
  Vec3 low = component.center.value_or(component.ports.front().center), high = low;
  double radius = 0;
  for (const PipingPort& port : component.ports) {
    if (component.center) {
      line.push_back(*component.center);
    }
    line.push_back(port.center);
    low = low.cwiseMin(port.center);
    high = high.cwiseMax(port.center);
    radius = std::max(radius, port.radius.value_or(0));
  }
  PagePlace place = marked((low + high) / 2, std::max((high - low).norm(), 2 * radius));
  place.lines = {std::move(line)};
  return place;
}

std::optional<PagePlace> place_of(std::size_t line, const PipingLine* piping,
                                  const PipeGraph* graph) {
  if (line > 0 && piping != nullptr) {
    for (const PipingComponent& component : piping->components) {
      const bool is_port = std::ranges::any_of(
          component.ports, [line](const PipingPort& port) { return port.line == line; });
      if ((component.line == line || is_port) && !component.ports.empty()) {
        return place_of(component);
      }
    }
  }
  if (line > 0 && graph != nullptr) {
    for (const GraphNode& node : graph->nodes) {
      if (node.line == line) {
        return marked(node.center, 4 * node.radius.value_or(1));
      }
    }
    for (const GraphEdge& edge : graph->edges) {
      if (edge.line == line && std::max(edge.from, edge.to) < graph->nodes.size()) {
        const Vec3 &a = graph->nodes[edge.from].center, &b = graph->nodes[edge.to].center;
        PagePlace place = marked((a + b) / 2, (a - b).norm());
        place.lines = {{a, b}};
        return place;
      }
    }
  }
  return std::nullopt;
}

const PipingComponent* component_called(const PipingLine* line, const std::string& name) {
  if (line == nullptr) {
    return nullptr;
  }
  const auto found = std::ranges::find(line->components, name, &PipingComponent::name);
  return found == line->components.end() || found->ports.empty() ? nullptr : &*found;
}

// Between the two ports that are nearest to each other.
std::optional<PagePlace> place_of(const PipingJoint& joint, const PipingLine* line) {
  const PipingComponent* const one = component_called(line, joint.components[0]);
  const PipingComponent* const other = component_called(line, joint.components[1]);
  if (one == nullptr || other == nullptr) {
    return std::nullopt;
  }
  std::pair<const PipingPort*, const PipingPort*> nearest{nullptr, nullptr};
  for (const PipingPort& a : one->ports) {
    for (const PipingPort& b : other->ports) {
      if (nearest.first == nullptr ||
          (a.center - b.center).norm() < (nearest.first->center - nearest.second->center).norm()) {
        nearest = {&a, &b};
      }
    }
  }
  const auto& [a, b] = nearest;
  PagePlace place =
      marked((a->center + b->center) / 2,
             std::max({2 * a->radius.value_or(0), 2 * b->radius.value_or(0), joint.distance}));
  place.lines = {{a->center, b->center}};
  return place;
}

}  // namespace

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string measure(double value, const std::string& unit, int power) {
  std::string text = decimal(value, kMessageDigits);
  if (!unit.empty()) {
    text += " " + unit + (power == 2 ? "\u00b2" : power == 3 ? "\u00b3" : "");
  }
  return text;
}

std::string at_most(double bound, const std::string& unit) {
  return "at most " + decimal_at_most(bound) + (unit.empty() ? "" : " " + unit);
}

std::vector<Vec3> outline(const Ring& ring) {
  std::vector<Vec3> points = sample(ring, {.segments = kOutlineSides});
  points.push_back(points.front());
  return points;
}

PageSection gap_section(const GapSummary& gaps) {
  PageSection section{"Gaps", "", {"verdict", "from", "to", "by"}};
  std::map<GapVerdict, std::size_t> counts;
  const std::string unit(symbol(gaps.unit));
  std::size_t welded = 0;
  for (const GapPair& pair : gaps.pairs) {
    ++counts[pair.report.verdict];
    if (pair.report.verdict != GapVerdict::welded || ++welded <= kMostWelded) {
      section.rows.push_back(gap_row(pair, gaps.ports, unit));
    }
  }
  const auto rank = [](const PageRow& row) {
    return row.is_finding ? 0 : row.cells[0] == name(GapVerdict::open) ? 1 : 2;
  };
  std::ranges::stable_sort(section.rows, {}, rank);
  for (const auto& [verdict, count] : counts) {
    section.note += (section.note.empty() ? "" : ", ") + std::to_string(count) + " " +
                    std::string(name(verdict));
  }
  section.note += (section.note.empty() ? "" : ". ") + std::string("Ends up to ") +
                  measure(gaps.connect, unit) + " apart were taken to belong together.";
  return section;
}

PageSection contact_section(const std::vector<Contact>& contacts,
                            const std::optional<ContactSettlement>& settled,
                            const std::string& unit, double size) {
  PageSection section{"Contacts", "Where the solid touches itself.", {"at", "between", ""}};
  section.is_counted = true;
  const auto add = [&](const Contact& contact, const std::string& what) {
    const bool is_edge = contact.kind == Contact::Kind::edge;
    PagePlace place = marked((contact.from + contact.to) / 2,
                             is_edge ? 2 * (contact.to - contact.from).norm() : size);
    if (is_edge) {
      place.lines = {{contact.from, contact.to}};
    }
    section.rows.push_back({{(is_edge ? "an edge at " : "a point at ") + decimal(contact.from),
                             listed(contact.names), what},
                            false,
                            std::move(place)});
  };
  for (const Contact& contact : contacts) {
    add(contact, "");
  }
  if (settled) {
    const bool is_bridge = settled->policy == "bridge";
    section.note = std::string("Where the solid touched itself: it was ") +
                   (is_bridge ? "bridged" : "separated") + " there, nothing changed beyond " +
                   measure(settled->length, unit) + ".";
    for (const Contact& contact : settled->contacts) {
      add(contact, is_bridge ? "bridged" : "separated");
    }
  }
  return section;
}

PageSection rounding_section(const RoundingReport& rounding, const std::string& unit, double size) {
  PageSection section{"Rounding", "", {"what", "at", "by"}};
  section.is_counted = true;
  section.note = rounding.moved == 0 ? "No point moved."
                                     : counted(rounding.moved, "point") + " moved, " +
                                           at_most(rounding.largest_move, unit) + ".";
  for (const Vec3& at : rounding.filled_places) {
    section.rows.push_back({{"slit filled", decimal(at), at_most(rounding.slit_width, unit)},
                            false,
                            marked(at, size)});
  }
  for (const Vec3& at : rounding.snapped_places) {
    section.rows.push_back({{"surface untangled", decimal(at), ""}, false, marked(at, size)});
  }
  for (const ThinShell& shell : rounding.thin_shells) {
    section.rows.push_back(
        {{"thin shell", decimal(shell.place),
          measure(shell.move, unit) + ", " + measure(shell.thickness, unit) + " thick"},
         false,
         marked(shell.place, size)});
  }
  return section;
}

PageSection note_section(const BuildReport& report, const PipingLine* line,
                         const PipeGraph* graph) {
  PageSection section{"Source", "What did not become what the file says.", {"", "line", "text"}};
  section.is_counted = true;
  const auto add = [&](const std::vector<SourceNote>& notes, const char* what, bool is_finding) {
    for (const SourceNote& note : notes) {
      section.rows.push_back({{note.is_refusal ? "refused" : what,
                               note.line > 0 ? std::to_string(note.line) : "", note.text},
                              note.is_refusal || is_finding,
                              place_of(note.line, line, graph)});
    }
  };
  if (report.graph) {
    add(report.graph->notes, "note", false);
  }
  if (report.piping) {
    add(report.piping->network.notes, "note", false);
    add(report.piping->file.notes, "bore", false);
    add(report.piping->file.unknown, "not understood", report.piping->is_strict);
  }
  std::ranges::stable_sort(section.rows, {}, [](const PageRow& row) { return !row.is_finding; });
  return section;
}

PageSection joint_section(const PcfReport& piping, const PipingLine* line) {
  PageSection section{"Joints", "", {"", "between", "distance", "step", "kink"}};
  section.is_counted = true;
  std::size_t met = 0;
  for (const PipingJoint& joint : piping.network.joints) {
    if (joint.state == JointState::met) {
      ++met;
      continue;
    }
    section.rows.push_back(
        {{std::string(name(joint.state)), joint.components[0] + " and " + joint.components[1],
          measure(joint.distance, "mm"), measure(joint.step, "mm"), measure(joint.kink, "rad")},
         joint.state == JointState::apart,
         place_of(joint, line)});
  }
  section.note =
      "Ends that belong together; " + std::to_string(met) + " more share a ring as they are.";
  std::ranges::stable_sort(section.rows, {}, [](const PageRow& row) { return !row.is_finding; });
  return section;
}

PageSection fault_section(const MeshSummary& summary, double size) {
  PageSection section{"Faults", "", {"what", "where"}};
  section.is_counted = true;
  const Report& check = summary.check;
  for (std::size_t i = 0; i < check.counts.size(); ++i) {
    if (check.counts[i] > 0) {
      section.note += (section.note.empty() ? "" : ", ") + std::to_string(check.counts[i]) + " " +
                      std::string(name(static_cast<Defect>(i)));
    }
  }
  section.note = section.note.empty() ? "None: the mesh is a solid." : section.note + ".";
  for (const Finding& finding : check.findings) {
    PageRow row{{std::string(name(finding.defect)), describe(finding, summary.mesh)},
                is_fatal(finding.defect)};
    if (finding.place.allFinite()) {
      row.place = marked(finding.place, size);
    }
    section.rows.push_back(std::move(row));
  }
  return section;
}

}  // namespace dupin::pages
