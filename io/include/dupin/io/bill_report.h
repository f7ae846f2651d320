#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dupin/blends/build.h"
#include "dupin/io/report_json.h"

namespace dupin {

/// Where a row of a bill comes from: a component of a piping file, and its line.
struct BillOrigin {
  std::string component;  ///< empty if there is none
  std::string kind;       ///< what the file calls it
  std::size_t line = 0;   ///< 0 if there is none
};

/// Of the union that is built, in which nothing counts twice.
struct MeshVolumes {
  double tolerance = 0;  ///< of the mesh, as it was asked for
  RegionVolumes volumes;
};

/// A bill of materials with what is asked for besides.
struct BillReport {
  BillOfMaterials bill;
  std::optional<double> density = {};    ///< in kg/m3; none: no masses
  std::vector<BillOrigin> origins = {};  ///< by BillRow::index; empty if there are none
  std::optional<MeshVolumes> mesh = {};  ///< where it was asked for
  BuildReport source = {};               ///< what became of the graph or piping file, nothing else
};

/// That of a row; empty if there is none.
[[nodiscard]] BillOrigin origin(const BillReport& report, const BillRow& row);

/// Kilograms of a volume in the bill's unit; none without a density.
[[nodiscard]] std::optional<double> mass(const BillReport& report, double volume);

/// Sizes of ends as one text: "DN100" where ASME B36.10M has a pipe of this outside diameter, else
/// "OD 12.5"; of ellipses "24 x 12". Ends that differ are separated by " / ".
[[nodiscard]] std::string size_text(const std::vector<EndSize>& sizes, Unit unit);

/// Rows of one kind, size and wall, and of elbows of one bend; of a piping file also of components
/// of one kind.
struct TakeOff {
  std::string component, kind, size;  ///< the first is BillOrigin::kind
  double wall = 0;
  std::optional<double> bend_radius, bend_angle;  ///< to 9 digits; the angle in degrees
  std::size_t count = 0;
  double length = 0;  ///< of those that have one
};

/// In the order of components' kinds, kinds, sizes, walls, radii and angles.
[[nodiscard]] std::vector<TakeOff> take_off(const BillReport& report);

/// The sums over all rows, and how many rows lack a term.
struct BillTotals {
  double area = 0;
  SolidMoments outer, metal, fluid;
  std::size_t without_area = 0, without_volume = 0;
};

[[nodiscard]] BillTotals totals(const BillOfMaterials& bill);

/// Keys as in docs/cli.md; numbers are the shortest decimals that read back to the same double.
[[nodiscard]] std::string to_json(const BillReport& report);

/// RFC 4180: a line of column names with their units, a line for each row and one of totals, each
/// ended by CR LF; texts are quoted, what is not known is empty.
[[nodiscard]] std::string to_csv(const BillReport& report);

}  // namespace dupin
