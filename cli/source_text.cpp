#include "source_text.h"

#include <algorithm>
#include <ostream>
#include <string>

#include "dupin/kernel/printable.h"
#include "report_text.h"

namespace dupin::cli {
namespace {

void print_notes(std::ostream& out, const char* row, const std::vector<SourceNote>& notes) {
  for (const SourceNote& note : notes) {
    print_row(out, note.is_refusal ? "refused" : row,
              (note.line > 0 ? "line " + std::to_string(note.line) + ": " : "") + note.text);
  }
}

void print_graph(std::ostream& out, const PipeNetwork& graph) {
  print_row(out, "graph",
            counted(graph.nodes, "node") + ", " + counted(graph.edges, "edge") + ", " +
                counted(graph.components, "component") + ", " + counted(graph.cycles, "cycle"));
  print_row(out, "nodes became",
            counted(graph.blends, "blend") + ", " + counted(graph.junctions, "junction") + ", " +
                counted(graph.balls, "ball"));
  print_notes(out, "note", graph.notes);
}

constexpr JointState kStates[] = {JointState::met, JointState::stepped, JointState::blended,
                                  JointState::bridged, JointState::apart};

std::size_t count_of(const PcfReport& piping, JointState state) {
  return std::size_t(std::ranges::count(piping.network.joints, state, &PipingJoint::state));
}

// How many joints have it, and which if something was done to them.
void print_joints(std::ostream& out, const PcfReport& piping, JointState state) {
  const auto& joints = piping.network.joints;
  const std::size_t count = count_of(piping, state);
  if (count > 0) {
    print_row(out, std::string(name(state)), counted(count, "joint"));
  }
  if (state == JointState::met) {
    return;
  }
  for (const PipingJoint& joint : joints) {
    if (joint.state == state) {
      out << "  " << printable(joint.components[0]) << " to " << printable(joint.components[1])
          << " (lines " << joint.lines[0] << ", " << joint.lines[1]
          << "): " << number(joint.distance) << " mm apart, step " << number(joint.step)
          << " mm, kink " << number(joint.kink) << " rad"
          << (joint.part.empty() ? "" : "; part " + printable(joint.part)) << '\n';
    }
  }
}

// What a person wants to know first.
std::string summary(const PcfReport& piping) {
  const auto refused =
      std::ranges::count_if(piping.network.notes, [](const SourceNote& n) { return n.is_refusal; });
  std::string text = counted(piping.network.components, "component") + ", " +
                     counted(piping.network.origins.size(), "part") + ", " +
                     counted(piping.network.open_ends, "open end") + "; joints:";
  std::string_view separator = " ";
  for (const JointState state : kStates) {
    text += std::string(separator) + std::to_string(count_of(piping, state)) + " " +
            std::string(name(state));
    separator = ", ";
  }
  return text + "; " + std::to_string(refused) + " refused";
}

void print_piping(std::ostream& out, const PcfReport& piping) {
  print_row(out, "summary", summary(piping));
  std::string kinds;
  for (const auto& [kind, count] : piping.file.kinds) {
    kinds += (kinds.empty() ? " (" : ", ") + std::to_string(count) + " " + kind;
  }
  print_row(out, "components",
            std::to_string(piping.network.components) + kinds + (kinds.empty() ? "" : ")"));
  print_row(out, "open ends", std::to_string(piping.network.open_ends));
  for (const JointState state : kStates) {
    print_joints(out, piping, state);
  }
  print_row(out, "moved", at_most(piping.network.largest_move, "mm"));
  print_source_notes(out, {piping.file.notes, piping.network.notes, piping.file.unknown});
}

}  // namespace

void print_source_notes(std::ostream& out, const SourceNotes& notes) {
  print_notes(out, "bore", notes.bores);
  print_notes(out, "note", notes.notes);
  print_notes(out, "warning", notes.unknown);
}

void print_source(std::ostream& out, const BuildReport& report) {
  if (report.graph) {
    print_graph(out, *report.graph);
  }
  if (report.piping) {
    print_piping(out, *report.piping);
  }
}

}  // namespace dupin::cli
