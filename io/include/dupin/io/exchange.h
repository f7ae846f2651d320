#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/blends/build.h"
#include "dupin/io/named_nurbs.h"

namespace dupin {

/// What becomes a solid of a STEP file.
enum class ExchangeSolids {
  united,  ///< what hangs together: where parts cross, faces are trimmed
  runs,    ///< parts that share rings, whatever they cross
  parts,   ///< every part, with discs at its ends
};

/// "united", "runs" or "parts".
[[nodiscard]] std::string_view name(ExchangeSolids solids);

struct ExchangeOptions {
  /// In the assembly's unit; none: the assembly's tolerance. Surfaces that are not rational are
  /// within a tenth of it.
  std::optional<double> tolerance;
  ExchangeSolids solids = ExchangeSolids::united;
  std::map<std::string, std::string> colours = {};  ///< of parts, as parse_document has them
};

/// A solid, as it was read back from the file.
struct ExchangedSolid {
  std::string name;
  double volume = 0, area = 0;  ///< in the assembly's unit
  std::size_t faces = 0, shells = 0;
  std::int64_t euler_number = 0;  ///< V - E + F of its boundary
};

/// What a STEP file holds. Lengths in the assembly's unit.
struct ExchangeReport {
  std::string file, format;
  std::vector<ExchangedSolid> solids;
  std::size_t faces = 0;
  std::size_t exact_surfaces = 0, lofted_surfaces = 0;  ///< before they were trimmed
  double error_bound = 0;                               ///< of the lofted ones, proved
  double edge_tolerance = 0;  ///< how far edges may be from the surfaces that meet there
  double volume = 0;          ///< of all solids
  /// What the volume was compared with, and by how much it may differ.
  std::optional<double> expected_volume;
  double volume_bound = 0;
};

/// A file that was made but is not yet written.
struct ExchangeFile {
  std::string bytes;
  ExchangeReport report;
};

/// Whether the module that makes these files can be loaded: it needs OpenCASCADE.
[[nodiscard]] bool can_exchange();

/// What is known before anything is built: throws what step_file would where solids of runs or
/// parts are asked for of another region than the outer one (`region`, or the one that `build`
/// makes of the assembly where none is asked for) or, unless it is of a network, of fillets;
/// Error{invalid_argument} without the module.
void require_exchange(const Assembly& assembly, std::optional<Region> region,
                      ExchangeSolids solids);

/// `built`, which `build` made of the assembly, as STEP (AP214) in millimetres: a boundary of
/// planes, cylinders, cones, spheres, tori and NURBS whose neighbours share edges and vertices;
/// products and faces with names, faces with colours. Surfaces are exact up to rounding where they
/// are rational, else within a tenth of the tolerance, as proved.
///
/// What is written has been read back: every solid is closed and valid (BRepCheck). Where they are
/// united, solids, shells and the Euler number are those of the exact solid, and so is the volume,
/// within what the distance of both from the smooth surface allows; solids of runs and parts have
/// the volumes that `measures` finds, where it does. Throws Error{boolean_failed} where this is not
/// so, or OpenCASCADE fails, or there are surfaces that it cannot hold yet (kneecaps, fillets whose
/// ball grows), naming the part; Error{invalid_argument} without the module.
[[nodiscard]] ExchangeFile step_file(const Assembly& assembly, const Built& built,
                                     const ExchangeOptions& options = {});

/// The surfaces, not trimmed by each other, as STEP or IGES in millimetres. Throws likewise.
[[nodiscard]] std::string surfaces_step(const std::vector<NamedNurbs>& parts, Unit unit);
[[nodiscard]] std::string surfaces_iges(const std::vector<NamedNurbs>& parts, Unit unit);

}  // namespace dupin
