#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/blends/assembly.h"
#include "dupin/blends/build.h"
#include "dupin/blends/edit_chain.h"
#include "dupin/blends/pipe_graph.h"
#include "dupin/blends/unit.h"
#include "dupin/io/exchange.h"
#include "dupin/io/pcf.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/cross_check.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/gap.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/mesh_gap.h"
#include "dupin/kernel/repair.h"
#include "dupin/kernel/rounding.h"
#include "dupin/kernel/solid.h"
#include "dupin/kernel/solver_mesh.h"
#include "dupin/kernel/stage_clock.h"

namespace dupin {

/// What `simplify` left out before.
struct SimplificationReport {
  std::size_t removed_triangles = 0;
  double deviation = 0;
};

/// What was made for solvers.
struct SolverMeshReport {
  RemeshReport surface;
  double asked_angle = 0, asked_distance = 0;
  struct Volume {
    std::size_t points = 0, tetrahedra = 0;
    double smallest_dihedral_angle = 0;  ///< in radians
  };
  std::optional<Volume> volume = std::nullopt;  ///< where tetrahedra were written
};

/// Contacts that were removed before, by taking material away ("separate") or adding it ("bridge").
struct ContactSettlement {
  std::string policy;
  double length = 0;  ///< nothing farther from a contact changed
  std::vector<Contact> contacts;
};

/// What repair() did to an operand.
struct FileRepair {
  std::string file;
  RepairReport report;
};

/// How what was read was put elsewhere before.
struct PlacementReport {
  bool is_exact = true;     ///< all numbers written are those asked for
  double largest_move = 0;  ///< no point is farther from where it was asked to be
};

/// What was made sure of before a file took its place.
enum class Verification {
  none,     ///< nothing: it was not read back
  compare,  ///< that it gives back, number by number, the mesh that rounding has proved
  full,     ///< by `check`, from the numbers read back alone
};

/// "none", "compare" or "full".
[[nodiscard]] std::string_view name(Verification verification);

/// What a mesh file that was written holds, and how it came to.
struct OutputReport {
  std::string file;
  std::string format;       ///< for people, "binary STL"
  RoundingReport rounding;  ///< of exact coordinates to the file's
  Verification verification = Verification::none;
  /// Of the file, none if it was not read back. Where it was compared, that nothing in it crosses
  /// is what rounding has proved.
  std::optional<Report> check;
  std::vector<Contact> contacts;  ///< where the solid touches itself
  std::optional<SimplificationReport> simplification = std::nullopt;
  std::optional<SolverMeshReport> solver_mesh = std::nullopt;
  std::optional<ContactSettlement> settled = std::nullopt;
  std::vector<FileRepair> repairs = {};  ///< of operands that needed some
  std::optional<PlacementReport> placement = std::nullopt;
  std::optional<CrossCheck> cross_check = std::nullopt;  ///< of the exact result, before rounding
  std::vector<StageTime> timing = {};  ///< where it was asked for: never the same twice

  /// Whether the cross-check disagrees. That the other engine failed is no finding about ours.
  [[nodiscard]] std::size_t findings() const {
    return cross_check && cross_check->verdict == CrossCheck::Verdict::disagrees ? 1 : 0;
  }
};

/// Empty for a mesh without points.
[[nodiscard]] Eigen::AlignedBox3d bounding_box(const TriMesh& mesh);

/// A mesh file, as it was read.
struct MeshSummary {
  std::string file;
  std::string unit;  ///< that the file states; may be empty
  TriMesh mesh;
  Report check;  ///< without self-intersections
};

/// How the ends of an assembly fit.
struct GapSummary {
  std::string file;
  Unit unit = Unit::millimetre;
  double connect = 0;  ///< ends up to this far apart were taken to belong together
  std::vector<Port> ports;
  std::vector<GapPair> pairs;
  std::optional<SourceNotes> source = {};  ///< of what was made of a graph or piping file

  /// Pairs that are neither welded nor open, and what of the source was left out.
  [[nodiscard]] std::size_t findings() const;
};

/// How two mesh files fit, or one by itself (then `file_b` is empty).
struct MeshGapSummary {
  std::string file_a, file_b;
  double connect = 0;
  MeshGapReport report;

  /// Boundary loops, slits, and a union that falls apart.
  [[nodiscard]] std::size_t findings() const;
};

/// A document that was built and written.
struct BuildReport {
  std::vector<PartReport> parts;
  std::size_t runs = 0, pieces = 0;
  double grid = 0;
  OutputReport output;  ///< of a STEP file its name and format alone
  GapSummary gaps;
  Region region = Region::outer;
  std::optional<RegionVolumes> volumes = {};  ///< of an assembly with walls
  std::optional<double> insulation = {};      ///< volume, if that is the region
  std::optional<PipeNetwork> graph = {};      ///< that was built, without its assembly
  std::optional<PcfReport> piping = {};
  std::optional<ExchangeReport> exchange = {};  ///< of a STEP file

  /// Those of the gaps, of the output, of the piping, and what of the graph was refused.
  [[nodiscard]] std::size_t findings() const;
  [[nodiscard]] std::size_t source_findings() const;  ///< of the graph or piping alone
};

/// A chain that was edited.
struct EditReport {
  struct MovedSphere {
    std::size_t sphere = 0;
    PeVector value;
  };
  std::string file, part;
  std::size_t pieces = 0;
  std::vector<std::size_t> changed;  ///< pieces that differ by any bit
  std::vector<MovedSphere> spheres;
  std::vector<TurnedPiece> turned;
};

/// A document that was put elsewhere.
struct PlacedDocumentReport {
  std::string file;
  Unit unit = Unit::millimetre;
  PlacementReport placement;
};

/// Whether the area of a report is that of the mesh. Of meshes with points that are not finite, or
/// out of range, places are not looked at.
[[nodiscard]] bool is_measured(const Report& report);

/// Whether its volumes are: what is not closed() has none, and no genus.
[[nodiscard]] bool has_volume(const Report& report);

/// JSON objects, indented by two, without a final line break, the same text for the same value;
/// keys as in docs/cli.md. Numbers are the shortest that read back to the same double, or null.
[[nodiscard]] std::string to_json(const Report& report);
[[nodiscard]] std::string to_json(const OutputReport& report);
[[nodiscard]] std::string to_json(const MeshSummary& summary);
/// What the document says, not what becomes of it.
[[nodiscard]] std::string to_json(const Assembly& assembly);
[[nodiscard]] std::string to_json(const GapSummary& summary);
[[nodiscard]] std::string to_json(const MeshGapSummary& summary);
[[nodiscard]] std::string to_json(const BuildReport& report);
/// What became of the graph or piping file alone.
[[nodiscard]] std::string source_json(const BuildReport& report);
[[nodiscard]] std::string to_json(const EditReport& report);
[[nodiscard]] std::string to_json(const PlacedDocumentReport& report);
/// `kind` is the error's name for programs, usually name(error.code()).
[[nodiscard]] std::string error_json(const Error& error, std::string_view kind, int exit_code);
/// In quotation marks, of any bytes: U+FFFD for what is no UTF-8.
[[nodiscard]] std::string string_json(std::string_view text);

}  // namespace dupin
