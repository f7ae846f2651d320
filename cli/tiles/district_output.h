#pragma once

#include <cstddef>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "dupin/io/mesh_stream.h"
#include "dupin/io/processes.h"
#include "dupin/io/report_json.h"
#include "dupin/kernel/districts.h"
#include "output.h"
#include "tiles/district_voids.h"

namespace dupin::cli {

/// How far boxes about what is given reach for districts to be rounded apart from each other: so
/// much, and this part of the largest coordinate.
struct DistrictMargin {
  double absolute = 0, relative = 0;
};

[[nodiscard]] DistrictMargin district_margin(const Destination& to, const RoundingOptions& rounding,
                                             const ContactChoice& contacts);

/// For districts: the whole's origin and, of its extent, the power of two that decides about
/// rounding, so that a change elsewhere hardly ever is one here.
[[nodiscard]] RoundingOptions rounding_of_districts(RoundingOptions rounding,
                                                    std::span<const Boxes> boxes);

/// The districts' solids settled, rounded and written as one mesh.
[[nodiscard]] OutputReport write_districts(std::span<const Solid> solids,
                                           std::span<const Boxes> boxes, const Destination& to,
                                           const RoundingOptions& rounding, MeshHeader header,
                                           const ContactChoice& contacts,
                                           TriMesh* written = nullptr,
                                           const NormalsOf& normals = {});

/// One of them settled and rounded, as its file has it.
struct DistrictOutput {
  OutputReport report;  ///< its check, rounding, contacts and what was settled
  MeshPiece piece;
  std::vector<std::string> seen;  ///< the names of the labels that the solid has, before rounding
  std::vector<SeamSide> sides;    ///< what it has at each of its seams
  std::vector<DistrictVoid> voids;
};

/// `rounding` is for districts. At its seams it is left open; one that cannot be rounded with its
/// ends, or leaves its boxes, has none there. Throws Error{internal} where a solid without seams
/// does not lie in its boxes; one that is alone need not.
[[nodiscard]] DistrictOutput district_output(const Solid& solid, std::span<const Boxes> boxes,
                                             std::size_t district, const DistrictPlaces& places,
                                             const Destination& to, const RoundingOptions& rounding,
                                             const ContactChoice& contacts,
                                             std::span<const Seam> seams = {});

/// Of a piece that cannot be made with its ends: nothing, at so many seams.
[[nodiscard]] DistrictOutput unfit_output(std::size_t seams);

/// A file that grows aside, district by district, and what there is to report of it. Functions
/// throw OutputError where it cannot be written. Several processes make it all at once, and the
/// same calls.
class DistrictFile {
 public:
  /// `places` are those of the districts, in the order in which they come.
  explicit DistrictFile(const Destination& to, std::vector<Vec3> places = {},
                        const Processes* processes = nullptr);
  /// `file` is MeshStream's.
  void append(DistrictOutput district, std::size_t file = 0);
  /// In another thread, while nothing else is called: commit() waits for less then.
  void flush();
  /// See require_something_left().
  void require_something(const RoundingOptions& rounding) const;
  /// The file takes its place. `normals` are asked for where the format has some.
  [[nodiscard]] OutputReport commit(MeshHeader header, const NormalsOf& normals = {});
  /// Nothing takes its place.
  void abandon() { stream_->abandon(); }
  /// Of the solids' labels, before rounding.
  [[nodiscard]] const std::set<std::string>& seen() const { return seen_; }

 private:
  void deepen_shells();

  Destination to_;
  std::vector<Vec3> places_;
  DistrictDepths depths_;
  std::vector<std::size_t> shells_before_;  // each district, in the report
  std::unique_ptr<MeshStream> stream_;
  OutputReport report_;
  std::set<std::string> seen_;
};

}  // namespace dupin::cli
