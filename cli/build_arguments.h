#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "document.h"
#include "dupin/blends/tessellation.h"
#include "output.h"
#include "rounding_options.h"
#include "solver_options.h"
#include "tiles/tile_options.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
}

namespace dupin::cli {

/// What --quality takes for meshes of solvers.
constexpr const char* kForSolvers = "cfd";

/// What `build` is told.
struct BuildArguments {
  std::vector<std::string> files;
  std::string connect, contacts, cross_check, region, solids, page;
  std::string quality;
  SolverArguments solver;
  WallArguments walls;
  OutputArguments output;
  std::uint32_t segments = 0;
  std::size_t most_triangles = kUsualTriangles;
  bool are_triangles_limited = false;  ///< by --triangles, which in tiles, too, is of all of them
  SourceArguments source;
  RoundingArguments rounding;
  TileArguments tiles;
};

/// Adds all options that say how a document becomes a solid, but not which document and where to.
void add_build_options(CLI::App& command, BuildArguments& arguments);

/// What is wrong with the output is said before anything is built. Throws UsageError.
void check_destination(const BuildArguments& arguments);

}  // namespace dupin::cli
