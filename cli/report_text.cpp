#include "report_text.h"

#include <algorithm>
#include <numbers>
#include <ostream>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/printable.h"

namespace dupin::cli {
namespace {

constexpr std::size_t kLabelWidth = 21;
/// A list on the screen ends here; JSON has the rest.
constexpr std::size_t kShownPerDefect = 5;
constexpr std::size_t kShownFaces = 4;

std::string powered(double value, std::string_view unit, std::string_view power) {
  return number(value) + (unit.empty() ? "" : " " + std::string(unit) + std::string(power));
}

std::string finding_text(const Finding& finding) {
  const bool of_faces = !finding.faces.empty();
  const auto& items = of_faces ? finding.faces : finding.points;
  std::string text = of_faces ? "face" : "point";
  text += items.size() == 1 ? "" : "s";
  for (std::size_t i = 0; i < std::min(items.size(), kShownFaces); ++i) {
    text += (i == 0 ? " " : ", ") + std::to_string(items[i]);
  }
  if (items.size() > kShownFaces) {
    text += ", ...";
  }
  return text + " at " + place_text(finding.place);
}

void print_findings(std::ostream& out, const Report& report) {
  for (std::size_t index = 0; index < report.counts.size(); ++index) {
    if (report.counts[index] == 0) {
      continue;
    }
    const auto defect = static_cast<Defect>(index);
    out << name(defect) << ": " << report.counts[index] << '\n';
    std::size_t shown = 0;
    for (const Finding& finding : report.findings) {
      if (finding.defect == defect && shown < kShownPerDefect) {
        out << "  " << finding_text(finding) << '\n';
        ++shown;
      }
    }
    if (report.counts[index] > shown) {
      out << "  and " << report.counts[index] - shown << " more\n";
    }
  }
}

void print_measures(std::ostream& out, const Report& report, std::string_view unit) {
  print_row(out, "triangles", std::to_string(report.triangles));
  print_row(out, "points", std::to_string(report.points));
  print_row(out, "components", std::to_string(report.components));
  print_row(out, "euler number", std::to_string(report.euler_number));
  print_sizes(out, report, unit);
  print_row(
      out, "self-intersections",
      is_measured(report) ? std::to_string(report.count(Defect::self_intersection)) : kUnknown);
}

std::string rounding_text(const RoundingReport& rounding, std::string_view unit) {
  if (rounding.moved == 0) {
    return "none";
  }
  return counted(rounding.moved, "point") + " moved, " + at_most(rounding.largest_move, unit);
}

std::string thin_shells_text(const std::vector<ThinShell>& shells, std::string_view unit) {
  const ThinShell& first = shells.front();
  const std::size_t others = shells.size() - 1;
  return "rounding moves points by up to " + powered(first.move, unit, "") +
         ", more than the shell there is thick, " + powered(first.thickness, unit, "") + ", at " +
         place_text(first.place) + (others > 0 ? ", and in " + counted(others, "other shell") : "");
}

void print_contacts(std::ostream& out, const std::vector<Contact>& contacts) {
  for (const Contact& contact : contacts) {
    out << "  " << (contact.kind == Contact::Kind::vertex ? "point " : "edge ")
        << place_text(contact.from);
    if (contact.kind == Contact::Kind::edge) {
      out << " to " << place_text(contact.to);
    }
    std::string_view separator = ": ";
    for (const std::string& name : contact.names) {
      out << separator << (name.empty() ? "(no name)" : printable(name));
      separator = ", ";
    }
    out << '\n';
  }
}

std::string repair_text(const RepairReport& report) {
  std::string text;
  const auto add = [&text](const std::string& what) { text += (text.empty() ? "" : ", ") + what; };
  const struct {
    std::size_t count;
    const char *noun, *done;
  } steps[] = {{report.merged_points, "point", " merged"},
               {report.degenerate_faces, "face", " without area dropped"},
               {report.duplicate_faces, "face", " dropped as duplicates"},
               {report.turned_faces, "face", " turned"}};
  for (const auto& [count, noun, done] : steps) {
    if (count > 0) {
      add(counted(count, noun) + done);
    }
  }
  if (report.united_overlaps) {
    add("overlaps united");
  }
  if (report.parted_contacts) {
    add("points doubled where it touches itself");
  }
  if (report.cavities > 0) {
    add(counted(report.cavities, "shell") + " kept as " +
        (report.cavities == 1 ? "a cavity" : "cavities"));
  }
  return text.empty() ? "nothing to mend" : text;
}

std::string degrees(double radians) {
  constexpr double kFull = 180;
  return decimal(radians * kFull / std::numbers::pi, 3) + " degrees";
}

void print_solver_mesh(std::ostream& out, const SolverMeshReport& report, std::string_view unit) {
  const RemeshReport& surface = report.surface;
  print_row(out, "angles",
            "at least " + degrees(surface.smallest_angle) +
                (surface.poor_triangles == 0 ? ""
                                             : ", " + counted(surface.poor_triangles, "triangle") +
                                                   " below " + degrees(report.asked_angle) + ", " +
                                                   std::to_string(surface.poor_between_edges) +
                                                   " of them between sharp edges, the first at " +
                                                   place_text(surface.worst.front().place)));
  print_row(out, "edges",
            "from " + powered(surface.shortest_edge, unit, "") + " to " +
                powered(surface.longest_edge, unit, ""));
  print_row(out, "deviation", at_most(surface.deviation, unit));
  if (report.volume) {
    print_row(out, "tetrahedra",
              std::to_string(report.volume->tetrahedra) + " of " +
                  counted(report.volume->points, "point") + ", dihedral angles at least " +
                  degrees(report.volume->smallest_dihedral_angle));
  }
}

std::string cross_check_text(const CrossCheck& check) {
  std::string engine(name(check.engine));
  switch (check.verdict) {
    case CrossCheck::Verdict::agrees:
      return engine + " agrees, exactly";
    case CrossCheck::Verdict::disagrees:
      return engine + " DISAGREES" + (check.place ? ", first at " + place_text(*check.place) : "") +
             ": its volume is " + number(check.other_volume.get_d()) + ", not " +
             number(check.volume.get_d());
    case CrossCheck::Verdict::engine_failed:
      return engine + " failed and has no opinion: " + check.failure;
  }
  return engine;
}

}  // namespace

std::string number(double value) { return decimal(value, 9); }

std::string at_most(double bound, std::string_view unit) {
  return "at most " + decimal_at_most(bound) + (unit.empty() ? "" : " " + std::string(unit));
}

std::string place_text(const Vec3& place) {
  return "(" + number(place.x()) + ", " + number(place.y()) + ", " + number(place.z()) + ")";
}

std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

void print_row(std::ostream& out, std::string_view label, std::string_view value) {
  const std::size_t gap = std::max<std::size_t>(kLabelWidth, label.size() + 1) - label.size();
  out << label << std::string(gap, ' ') << printable(value) << '\n';
}

std::string placement_text(bool is_exact, double largest_move, std::string_view unit) {
  return is_exact ? "exactly" : "not exactly, points " + at_most(largest_move, unit) + " off";
}

std::string verified_text(Verification verification) {
  switch (verification) {
    case Verification::none:
      return "no";
    case Verification::compare:
      return "read back, as it was proved";
    case Verification::full:
      return "read back and checked";
  }
  return "unknown";
}

void print_sizes(std::ostream& out, const Report& report, std::string_view unit) {
  const bool is_known = is_measured(report);
  if (report.closed()) {
    print_row(out, "volume", is_known ? powered(report.volume, unit, "^3") : kUnknown);
  }
  print_row(out, "area", is_known ? powered(report.area, unit, "^2") : kUnknown);
  print_row(out, "watertight", report.closed() ? "yes" : "no");
}

void print_report(std::ostream& out, const Report& report) {
  print_measures(out, report, "");
  print_row(out, "solid", report.is_solid() ? "yes" : "no");
  print_findings(out, report);
}

void print_output(std::ostream& out, const OutputReport& report, std::string_view unit) {
  print_row(out, "written", report.file + ", " + report.format);
  if (report.check) {
    print_measures(out, *report.check, unit);
  }
  if (report.simplification) {
    print_row(out, "simplified",
              counted(report.simplification->removed_triangles, "triangle") + " less, deviation " +
                  at_most(report.simplification->deviation, unit));
  }
  if (report.solver_mesh) {
    print_solver_mesh(out, *report.solver_mesh, unit);
  }
  if (report.placement) {
    print_row(out, "placed",
              placement_text(report.placement->is_exact, report.placement->largest_move, unit));
  }
  print_row(out, "rounding", rounding_text(report.rounding, unit));
  print_row(out, "verified", verified_text(report.verification));
  const std::vector<Vec3>&filled = report.rounding.filled_places,
        &snapped = report.rounding.snapped_places;
  if (!filled.empty()) {
    print_row(out, "slits",
              std::to_string(filled.size()) + " filled, " +
                  at_most(report.rounding.slit_width, unit) + " wide, first at " +
                  place_text(filled.front()));
  }
  if (!snapped.empty()) {
    print_row(out, "snapped",
              counted(snapped.size(), "time") + ", first at " + place_text(snapped.front()));
  }
  if (report.rounding.removed_shells > 0) {
    print_row(out, "removed",
              counted(report.rounding.removed_shells, "shell") +
                  " that the numbers of the format cannot hold");
  }
  if (!report.rounding.thin_shells.empty()) {
    print_row(out, "warning", thin_shells_text(report.rounding.thin_shells, unit));
  }
  if (report.rounding.origin != Vec3::Zero()) {
    print_row(out, "origin", place_text(report.rounding.origin));
  }
  if (report.settled) {
    print_row(out, "contacts",
              std::to_string(report.settled->contacts.size()) +
                  (report.settled->policy == "bridge" ? " bridged" : " separated") + " within " +
                  powered(report.settled->length, unit, ""));
    print_contacts(out, report.settled->contacts);
  } else if (!report.contacts.empty()) {
    print_row(out, "contacts", std::to_string(report.contacts.size()));
    print_contacts(out, report.contacts);
  }
  if (report.cross_check) {
    print_row(out, "cross-check", cross_check_text(*report.cross_check));
  }
  for (const FileRepair& repair : report.repairs) {
    print_row(out, "repaired", repair.file + ": " + repair_text(repair.report));
  }
}

void print_timing(std::ostream& out, const std::vector<StageTime>& timing) {
  for (const StageTime& time : timing) {
    print_row(out, time.stage,
              decimal(time.wall, 3) + " s, of processors " + decimal(time.processor, 3) + " s");
  }
}

}  // namespace dupin::cli
