#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/blends/assembly.h"
#include "dupin/blends/part_measures.h"
#include "dupin/blends/resolve.h"
#include "dupin/blends/tessellation.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/cross_check.h"
#include "dupin/kernel/districts.h"
#include "dupin/kernel/gap.h"
#include "dupin/kernel/progress.h"
#include "dupin/kernel/solid.h"

namespace dupin {

/// What of an assembly is built; the outer region is metal and fluid together, exactly.
enum class Region : std::uint8_t {
  outer,       ///< what the outer surfaces bound, as if there were no walls
  metal,       ///< the walls and the solid parts
  fluid,       ///< what the walls enclose, up to the planes of the open ends
  insulation,  ///< what lies around the outer region, up to the planes of the open ends
};

[[nodiscard]] std::string_view name(Region region);  ///< as its enumerator

struct BuildOptions {
  std::optional<double> tolerance;        ///< instead of the document's, in its unit
  std::optional<std::uint32_t> segments;  ///< instead of the document's
  double connect = 0;  ///< ends that face each other at most so far apart are measured as a pair
  /// What the parts' meshes may have together, by an estimate made before they are; a build needs
  /// 400 bytes for each. 50 million are the most for one part.
  std::size_t most_triangles = kUsualTriangles;
  ContactPolicy contacts = ContactPolicy::report;
  std::uint64_t memory_limit = 0;               ///< of each boolean operation; see BooleanOptions
  std::optional<CrossCheckEngine> cross_check;  ///< to check the union of the pieces by
  Progress progress;                            ///< may be empty
  std::optional<Region> region;  ///< none: metal of an assembly that has walls, else outer
  /// Boxes about parts are wider by so much, and by so much of the largest coordinate, where
  /// districts are found (none negative): each can be rounded by itself if no point moves further.
  double margin = 0, relative_margin = 0;
  /// What hangs together and is expected to have more triangles than both is divided into pieces of
  /// about the first, where it can be; 0: nothing is. For DistrictBuild, but not for `build`.
  double most_of_piece = 0, most_undivided = 0;
  std::set<std::string> kept_seams;  ///< names of those at which nothing is divided
};

/// What became of one part.
struct PartReport {
  std::string name;
  std::uint32_t index = 0;  ///< in Assembly::parts
  std::string kind;         ///< its key in a document: "pipe", "cyclic_blend", ...
  /// What a cyclide part turned out to be: "single", "double" or "triple" cyclide, "ringed" blend,
  /// or "6 pieces" of a chain. Empty for other parts.
  std::string construction;
  std::vector<std::string> rejected;  ///< CyclideSearch::rejected of a cyclide_blend
  std::vector<std::string> warnings;  ///< what its designer may not have meant, as sentences
  /// Certified bounds of min(1 - kappa R) along the part; none for spheres.
  std::optional<double> margin_lower, margin_upper;
  /// Certified upper bounds of the angles, in radians, between a blend's tangent planes at its
  /// start and end and those of its neighbours (Tangency::deviation); none for other parts.
  std::optional<double> start_tangency, end_tangency;
  double error_bound = 0;      ///< of the distance between smooth surface and mesh, both ways
  std::uint32_t segments = 0;  ///< around
  std::uint32_t bands = 0;     ///< along
  std::size_t triangles = 0;   ///< of the part alone, without end discs
  double smallest_angle = 0;   ///< of its triangles, in radians
  /// A proved lower bound of how far the bore's surface is from the outer one, which is at most the
  /// wall; none of a part without a bore, and where none is proved.
  std::optional<double> least_wall;
  bool is_hollow = false;  ///< it has a bore
};

/// The volumes of the regions: of a district the doubles nearest to the exact ones, of several
/// their sums.
struct RegionVolumes {
  double outer = 0, metal = 0, fluid = 0;
};

/// A built assembly.
struct Built {
  Solid solid;
  std::vector<PartReport> parts;  ///< in document order, without caps
  std::vector<Port> ports;        ///< all, in document order
  std::vector<GapPair> gaps;      ///< how the ports fit, measured exactly; see pair_ends
  std::size_t runs = 0;           ///< sets of parts welded to each other along shared rings
  std::size_t pieces = 0;         ///< solids that were united; more than runs if parts of one run
                                  ///< cross each other
  double grid = 0;                ///< spacing of the lattice that the mesh points lie on
  std::optional<CrossCheck> cross_check;  ///< of `solid`, where it was asked for
  Region region = Region::outer;          ///< the one that `solid` is
  std::optional<RegionVolumes> volumes;   ///< of an assembly with walls
  std::optional<double> insulation;       ///< its volume, if it was asked for
  std::vector<Solid> districts;           ///< what `solid` is joined from
  std::vector<Boxes> boxes;               ///< about each
};

/// The whole line: resolve, certify, tessellate, weld, unite. The labels of the solid name the part
/// of every triangle, or the cap or "part.start" of an end disc, and "part.bore" inside of a wall.
/// Where there are walls, meshes keep to a quarter of the thinnest if that is less than the
/// tolerance.
///
/// Throws Error{irregular_surface} for a blend that folds, Error{self_intersecting} for a part that
/// crosses itself, Error{infeasible_blend} for a wall that leaves no bore or that a bore breaks
/// through, Error{limit_exceeded} for more triangles than `most_triangles` (of the outer surfaces,
/// or of the bores), and what `resolve`, `unite` throw; each names the part.
[[nodiscard]] Built build(const Assembly& assembly, const BuildOptions& options = {});

/// A build of one district after the other: of parts that have nothing to do with the others,
/// because boxes about them do not touch (dupin/kernel/districts.h).
class DistrictBuild {
 public:
  /// Resolves the assembly and finds its districts, at least one, in the order of their first
  /// parts. O(n log n) and the pairs of boxes that touch. Throws what `build` throws before a mesh
  /// is made; the others throw Error{invalid_argument} for a number of no district.
  explicit DistrictBuild(const Assembly& assembly, const BuildOptions& options = {});
  // No moves: they would leave one without a plan behind.
  DistrictBuild(const DistrictBuild&) = default;
  DistrictBuild& operator=(const DistrictBuild&) = default;

  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] std::vector<Boxes> boxes() const;  ///< about each district
  /// Where districts are pieces that are joined again: a solid of one has discs there.
  [[nodiscard]] const std::vector<Seam>& seams() const;
  /// What a piece takes from the whole, as text; empty for what is no piece.
  [[nodiscard]] std::string taken_from_whole(std::size_t district) const;
  /// Its parts, by their places in Assembly::parts, ascending.
  [[nodiscard]] std::vector<std::uint32_t> parts(std::size_t district) const;
  /// A document of all that decides about one district, but for the options: its parts, those that
  /// they refer to, and names of their ends.
  [[nodiscard]] Assembly document(std::size_t district) const;
  /// How many triangles its parts will have, roughly.
  [[nodiscard]] double expected_triangles(std::size_t district) const;
  /// Throws Error{limit_exceeded} for more triangles in all than BuildOptions::most_triangles.
  void refuse_too_costly() const;
  /// What is made of one district, as if there were no others; without ports and gaps. Threads may
  /// build several at a time. `memory_limit` is that of this one, unless it is 0.
  [[nodiscard]] Built build(std::size_t district, const Progress& progress = {},
                            std::uint64_t memory_limit = 0) const;
  /// What `build` gives for the assembly; districts are built side by side. There are no seams.
  [[nodiscard]] Built build_all(const Progress& progress = {}) const;
  /// The same, of what it gave for all districts in order, whose solids may be gone.
  [[nodiscard]] Built joined(std::vector<Built> districts) const;

 private:
  struct Plan;
  std::shared_ptr<const Plan> plan_;
};

/// The largest error bound of the parts' meshes.
[[nodiscard]] double mesh_error(const Built& built);

/// In smooth surfaces: the whole; of metal and insulation, less the inside; of the fluid, what both
/// share. `kept` is taken from the inside before, which reaches out of open ends for clean rims.
struct SmoothRegion {
  Region region = Region::outer;
  ResolvedAssembly whole, inside, kept;
};

/// That of `built`, which `build` made of the assembly.
[[nodiscard]] SmoothRegion smooth_region(const Assembly& assembly, const Built& built);

/// The diameters of an end, outside: of a circle the same twice, else along and across the axis.
using EndSize = std::array<double, 2>;

/// One part of an assembly, a junction with its arms being one. Lengths are in the assembly's unit.
struct BillRow {
  std::string name, kind;
  std::uint32_t index = 0;       ///< in Assembly::parts
  std::vector<EndSize> sizes;    ///< of start and end, or of a junction's ends; of a ball its own
  double wall = 0;               ///< 0: solid
  std::optional<double> length;  ///< of the axis, from end to end
  std::optional<double> bend_radius, bend_angle;  ///< of an arc; the angle in radians
  std::optional<double> area;                     ///< of the outer surface, without end discs
  std::optional<SolidMoments> outer;         ///< what the outer surface and the end discs bound
  std::optional<SolidMoments> metal, fluid;  ///< its wall, and what this encloses
  std::vector<std::string> remarks;          ///< what is missing and why, what is not trimmed
};

/// What an assembly's parts measure, each by itself: what lies in two of them counts in both.
struct BillOfMaterials {
  std::string source;
  Unit unit = Unit::millimetre;
  std::vector<BillRow> rows;
};

/// In document order, without caps. Throws as `build` does before it makes a mesh, and as
/// `measures`.
[[nodiscard]] BillOfMaterials bill_of_materials(const Assembly& assembly);

}  // namespace dupin
