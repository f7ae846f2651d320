#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "dupin/io/mesh_header.h"
#include "dupin/io/report_json.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/districts.h"
#include "output.h"
#include "ranks.h"
#include "tiles/district_output.h"
#include "tiles/tile_options.h"

namespace dupin::cli {

/// About all corners of triangles.
[[nodiscard]] Eigen::AlignedBox3d box_of(const TriMesh& mesh);

/// Operands in groups whose boxes touch: the union is that of each, side by side.
///
/// Both are in the order of their places, so that what is made of them does not depend on the order
/// in which operands are given.
struct OperandDistricts {
  std::vector<std::vector<std::size_t>> operands;  ///< per district
  std::vector<Boxes> boxes;                        ///< likewise
};

/// At least one district; operands without triangles, which have no boxes, come last in the first.
[[nodiscard]] OperandDistricts operand_districts(std::span<const Eigen::AlignedBox3d> boxes,
                                                 const DistrictMargin& margin);

/// The unions of the districts' operands.
[[nodiscard]] std::vector<Solid> united_districts(std::span<const Solid> operands,
                                                  const OperandDistricts& districts,
                                                  const BooleanOptions& options);

/// A union of files that is made tile by tile.
struct TiledUnion {
  std::vector<std::string> files;
  Destination to;
  RoundingOptions rounding;
  ContactChoice contacts;
  bool are_repaired = false;
  TileArguments tiles;
  Progress progress;
};

/// The operands' files as far as they have to be known before.
struct OperandFiles {
  std::vector<Eigen::AlignedBox3d> boxes;
  std::vector<std::size_t> triangles;
  std::string unit;  ///< which all agree on
};

/// Reads one file after the other, as many at a time as there are threads; ranks share them. Throws
/// as read_mesh, and Error{invalid_argument} where units differ.
[[nodiscard]] OperandFiles survey(const std::vector<std::string>& files, const Progress& progress,
                                  const Ranks& ranks);

/// Reads the files of each tile again, unites them, and appends the result to the file: the bytes
/// that are written of united_districts, in the memory that the largest tile needs. Ranks share the
/// districts.
[[nodiscard]] OutputReport unite_in_tiles(const TiledUnion& task, const OperandFiles& files,
                                          const Ranks& ranks);

}  // namespace dupin::cli
