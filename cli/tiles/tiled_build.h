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
void add_build_tile_options(CLI::App& command, TileArguments& arguments);

/// Of how many triangles, expected, pieces may be for this output. Nothing is divided but what is
/// written to a binary STL or PLY, or a `.pvtu`, and not looked at otherwise.
void prepare_pieces(const BuildArguments& arguments, BuildOptions& options);

/// Throws UsageError for what a build in tiles cannot do, before anything is built.
void check_tiled(const BuildArguments& arguments);

struct TiledBuilt {
  Built built;  ///< with an empty solid
  OutputReport output;
  std::string warning;  ///< of this rank's cache, for people; empty if there is none
};

/// Builds the districts of the document in tiles, some at a time, and appends each to the file: the
/// same bytes as `build` and `write_districts` give, in the memory that the largest tile needs.
/// Ranks share the districts; each writes the facets of its own, and knows what there is to report.
[[nodiscard]] TiledBuilt build_in_tiles(const Document& document, const BuildOptions& options,
                                        const BuildArguments& arguments, const MeshHeader& header,
                                        const Ranks& ranks);

}  // namespace dupin::cli
