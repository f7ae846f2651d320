#pragma once

#include <cstddef>
#include <string>

#include "build_arguments.h"
#include "document.h"
#include "dupin/blends/build.h"
#include "dupin/io/report_json.h"
#include "ranks.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
}

namespace dupin::cli {

/// Adds --tiles, --memory and --cache.
void add_tile_options(CLI::App& command, TileArguments& arguments);

/// Whether the document is to be built tile by tile.
[[nodiscard]] bool is_tiled(const TileArguments& arguments, const Ranks& ranks);

/// Throws UsageError for what a build in tiles cannot do, before anything is built.
void check_tiled(const BuildArguments& arguments);

/// How far boxes about parts reach for districts to be rounded apart from each other.
void set_district_margin(BuildOptions& options, const Destination& to,
                         const RoundingOptions& rounding, const ContactChoice& contacts);

/// The districts' solids settled, rounded and written as one mesh.
[[nodiscard]] OutputReport write_districts(const Built& built, const Destination& to,
                                           const RoundingOptions& rounding, MeshHeader header,
                                           const ContactChoice& contacts, TriMesh* written,
                                           const NormalsOf& normals = {});

/// Builds the districts of the document in tiles, some at a time, and appends each to the file: the
/// same bytes as `build` and `write_districts` give, in the memory that the largest tile needs.
/// Ranks share the districts; the first one writes the file, and knows what there is to report. The
/// solid of what is returned is empty.
[[nodiscard]] Built build_in_tiles(const Document& document, const BuildOptions& options,
                                   const BuildArguments& arguments, const MeshHeader& header,
                                   const Ranks& ranks, OutputReport& report);

}  // namespace dupin::cli
