#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dupin/io/report_page.h"

namespace dupin::pages {

/// "1 point", "2 points".
[[nodiscard]] std::string counted(std::size_t count, const std::string& noun);

/// A number to six digits, with its unit to a power if there is one.
[[nodiscard]] std::string measure(double value, const std::string& unit = {}, int power = 1);
/// "at most 0.0123457 mm", which holds.
[[nodiscard]] std::string at_most(double bound, const std::string& unit);

/// A ring as a polyline.
[[nodiscard]] std::vector<Vec3> outline(const Ring& ring);

/// Pairs of ends with what keeps them apart, findings first. Those that are welded are counted
/// alone where there are more than a thousand.
[[nodiscard]] PageSection gap_section(const GapSummary& gaps);

/// Where the solid touches itself, or did before that was settled; `size` of what is to be seen
/// there.
[[nodiscard]] PageSection contact_section(const std::vector<Contact>& contacts,
                                          const std::optional<ContactSettlement>& settled,
                                          const std::string& unit, double size);

/// What the one rounding did besides moving points to the nearest numbers.
[[nodiscard]] PageSection rounding_section(const RoundingReport& rounding, const std::string& unit,
                                           double size);

/// What was left out of a graph or piping file, or changed, with the place that the file has for
/// it; `line` or `graph` may be null. Without rows if there is nothing.
[[nodiscard]] PageSection note_section(const BuildReport& report, const PipingLine* line,
                                       const PipeGraph* graph);

/// Ends of a piping file's components for which something was made, or nothing.
[[nodiscard]] PageSection joint_section(const PcfReport& piping, const PipingLine* line);

/// Faults of a mesh.
[[nodiscard]] PageSection fault_section(const MeshSummary& summary, double size);

/// Claims by their verdict, and every one that is not proved; of others the nearest hundred.
[[nodiscard]] PageSection certificate_section(const Certificate& certificate);

}  // namespace dupin::pages
