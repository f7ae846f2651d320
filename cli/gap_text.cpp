#include "gap_text.h"

#include <algorithm>
#include <ostream>

#include "report_text.h"
#include "source_text.h"

namespace dupin::cli {
namespace {

std::size_t count(const GapSummary& summary, GapVerdict verdict) {
  return static_cast<std::size_t>(
      std::count_if(summary.pairs.begin(), summary.pairs.end(),
                    [verdict](const GapPair& pair) { return pair.report.verdict == verdict; }));
}

/// Neither welded nor open.
bool is_gap(const GapPair& pair) {
  return pair.report.verdict != GapVerdict::welded && pair.report.verdict != GapVerdict::open;
}

bool is_length(Deviation::Kind kind) {
  return kind == Deviation::Kind::axial || kind == Deviation::Kind::radius ||
         kind == Deviation::Kind::across || kind == Deviation::Kind::offset;
}

/// The middle of an enclosure, which is so narrow that this says all that fits on a line.
std::string middle(const Enclosure& enclosure) {
  return number((enclosure.lower + enclosure.upper) / 2);
}

/// "axial 0.1 mm".
std::string deviation_text(const Deviation& deviation, Unit unit) {
  std::string text = std::string(name(deviation.kind)) + " " + middle(deviation.size);
  if (is_length(deviation.kind)) {
    text += " " + std::string(symbol(unit));
  } else if (deviation.kind == Deviation::Kind::kink || deviation.kind == Deviation::Kind::turn) {
    text += " rad";
  }
  return text;
}

void print_loops(std::ostream& out, const std::string& file,
                 const std::vector<BoundaryLoop>& loops) {
  for (const BoundaryLoop& loop : loops) {
    out << "  boundary of " << file << ": " << counted(loop.points.size(), "point") << ", length "
        << middle(loop.length) << ", around " << place_text(loop.place) << '\n';
  }
}

}  // namespace

void print_gaps(std::ostream& out, const GapSummary& summary) {
  print_row(out, "welded", std::to_string(count(summary, GapVerdict::welded)));
  print_row(out, "open", std::to_string(count(summary, GapVerdict::open)));
  print_row(out, "gaps", std::to_string(std::ranges::count_if(summary.pairs, is_gap)));
  for (const GapPair& pair : summary.pairs) {
    if (!is_gap(pair)) {
      continue;
    }
    out << "  " << name(pair.report.verdict) << ": " << summary.ports.at(pair.first).name << " to "
        << summary.ports.at(pair.second.value()).name;
    std::string_view separator = ": ";
    for (const Deviation& deviation : pair.report.deviations) {
      out << separator << deviation_text(deviation, summary.unit);
      separator = ", ";
    }
    out << '\n';
  }
  if (summary.source) {
    print_source_notes(out, *summary.source);
  }
}

void print_mesh_gaps(std::ostream& out, const MeshGapSummary& summary) {
  const MeshGapReport& report = summary.report;
  print_row(out, "boundary loops",
            std::to_string(report.boundary_a.size() + report.boundary_b.size()));
  print_loops(out, summary.file_a, report.boundary_a);
  print_loops(out, summary.file_b, report.boundary_b);
  if (summary.file_b.empty()) {
    return;
  }
  print_row(out, "welded faces", std::to_string(report.welded_faces));
  print_row(out, "slits", std::to_string(report.facing.size()));
  for (const GapRegion& region : report.facing) {
    out << "  " << counted(region.pairs, "pair") << " of faces, " << middle(region.least) << " to "
        << middle(region.greatest) << " apart, at " << place_text(region.place) << '\n';
  }
  print_row(out, "touching", report.touching ? "yes" : "no");
  print_row(out, "union", counted(report.components, "component"));
  if (report.components > 1) {
    out << "  apart: " << summary.file_a << " and " << summary.file_b
        << (report.touching ? " touch, but are not one piece" : " do not touch")
        << (report.facing.empty() ? ", and no faces look at each other from within " +
                                        number(summary.connect) + "; see --connect"
                                  : "")
        << '\n';
  }
}

}  // namespace dupin::cli
