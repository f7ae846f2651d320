#include "source_text.h"

#include <algorithm>
#include <ostream>
#include <string>

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

// How many joints have it, and which if something was done to them.
void print_joints(std::ostream& out, const PcfReport& piping, JointState state) {
  const auto& joints = piping.network.joints;
  const auto count =
      static_cast<std::size_t>(std::ranges::count(joints, state, &PipingJoint::state));
  if (count > 0) {
    print_row(out, std::string(name(state)), counted(count, "joint"));
  }
  if (state == JointState::met) {
    return;
  }
  for (const PipingJoint& joint : joints) {
    if (joint.state == state) {
      out << "  " << joint.components[0] << " to " << joint.components[1] << " (lines "
          << joint.lines[0] << ", " << joint.lines[1] << "): " << number(joint.distance)
          << " mm apart, step " << number(joint.step) << " mm, kink " << number(joint.kink)
          << " rad" << (joint.part.empty() ? "" : "; part " + joint.part) << '\n';
    }
  }
}

void print_piping(std::ostream& out, const PcfReport& piping) {
  std::string kinds;
  for (const auto& [kind, count] : piping.file.kinds) {
    kinds += (kinds.empty() ? " (" : ", ") + std::to_string(count) + " " + kind;
  }
  print_row(out, "components",
            std::to_string(piping.network.components) + kinds + (kinds.empty() ? "" : ")"));
  print_row(out, "open ends", std::to_string(piping.network.open_ends));
  for (const JointState state : {JointState::met, JointState::stepped, JointState::blended,
                                 JointState::bridged, JointState::apart}) {
    print_joints(out, piping, state);
  }
  print_row(out, "moved", "at most " + number(piping.network.largest_move) + " mm");
  print_notes(out, "bore", piping.file.notes);
  print_notes(out, "note", piping.network.notes);
  print_notes(out, "warning", piping.file.unknown);
}

}  // namespace

void print_source(std::ostream& out, const BuildReport& report) {
  if (report.graph) {
    print_graph(out, *report.graph);
  }
  if (report.piping) {
    print_piping(out, *report.piping);
  }
}

}  // namespace dupin::cli
