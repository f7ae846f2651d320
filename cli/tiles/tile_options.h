#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "dupin/kernel/districts.h"
#include "output.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
}

namespace dupin::cli {

/// What hangs together and is expected to have more triangles is divided. Files depend on it.
constexpr std::size_t kUndividedTriangles = 1'000'000;

/// Into pieces of at most about so many, what a document describes: the smaller they are, the less
/// is made again after an edit. Unions have larger ones, as operands are cut at every seam.
constexpr std::size_t kPieceTriangles = 30'000;

/// So often pieces are made that turn out not to fit; then nothing is divided.
constexpr int kMostRounds = 4;

/// What `attempt` makes of the most triangles that a piece may have, once it is something. Where
/// it is nothing, some pieces do not fit, which it leaves whole the next time.
template <class Attempt>
[[nodiscard]] auto until_pieces_fit(double most_of_piece, const Attempt& attempt) {
  for (int round = 1;; ++round) {
    if (auto made = attempt(most_of_piece)) {
      return *std::move(made);
    }
    most_of_piece = round < kMostRounds ? most_of_piece : 0;
  }
}

/// --tiles, --memory, --cache and --cache-size as typed.
struct TileArguments {
  std::size_t tiles = 0;
  std::optional<std::size_t> piece;  ///< of both, for tests
  std::string memory, cache, cache_size;

  [[nodiscard]] double most_undivided() const {
    return static_cast<double>(piece.value_or(kUndividedTriangles));
  }
  [[nodiscard]] double most_of_piece() const {
    return static_cast<double>(piece.value_or(kPieceTriangles));
  }
};

/// What --tiles means where a file is written tile by tile, each of some of `what`.
[[nodiscard]] std::string tiles_of(const std::string& what);

/// Adds --tiles, which means what the help text says, and --memory.
void add_tile_options(CLI::App& command, TileArguments& arguments, const std::string& meaning);

/// A number of bytes, such as 500MB or 4GB. Throws UsageError, naming the option.
[[nodiscard]] std::uint64_t bytes_in(const std::string& text, const std::string& option);

/// Whether the output is a .pvtu, which is made in districts whatever is asked for.
[[nodiscard]] bool is_in_files(const OutputArguments& output);

/// destination(), which may be a .pvtu here.
[[nodiscard]] Destination tiled_destination(const OutputArguments& output);

/// Whether tiles are asked for.
[[nodiscard]] bool is_tiled(const TileArguments& arguments);

/// What is said of files that cannot be written tile by tile.
inline constexpr const char* kTiledFormats =
    "--tiles, --memory, --cache and mpirun write binary STL, binary PLY and .pvtu files only";

/// Why the file cannot be written piece by piece; empty if it can.
[[nodiscard]] std::string why_not_tiled(const Destination& to);

/// Throws UsageError where the file cannot be written tile by tile, or the arguments mean nothing.
void require_tiled_output(const Destination& to, const TileArguments& arguments);

/// What there is to divide.
struct Divided {
  std::span<const Boxes> districts;
  /// About how many each has, and how many bytes of memory that takes; asked for with --memory
  /// only.
  std::span<const double> triangles, bytes;
  std::size_t processes = 1;  ///< that make tiles side by side
  std::string source;         ///< what messages name
  std::string remedy = {};    ///< besides more memory
};

/// Behind which districts tiles end. Throws Error{limit_exceeded} where one does not fit into the
/// memory.
[[nodiscard]] std::vector<std::size_t> ends_of_tiles(const TileArguments& arguments,
                                                     const Divided& divided);

}  // namespace dupin::cli
