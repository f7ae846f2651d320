#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "dupin/io/processes.h"
#include "tiles/district_result.h"

namespace dupin::cli {

/// The process that makes each of so many districts of a tile, of which that many triangles are
/// expected: the largest first, each to the one that has least to do.
[[nodiscard]] std::vector<std::size_t> shared_out(std::span<const double> triangles,
                                                  std::size_t processes);

/// The same of every tile, given behind which districts they end.
[[nodiscard]] std::vector<std::size_t> shared_out(std::span<const double> triangles,
                                                  std::span<const std::size_t> ends,
                                                  std::size_t processes);

/// How the districts of a tile are made, and the parts of the document that each has.
struct TileWork {
  std::function<DistrictResult(std::size_t)> made;
  std::function<std::vector<std::uint32_t>(std::size_t)> parts;
};

/// What a tile's districts come out as: those that this process owns are made, as many at a time as
/// there are threads; of the others it has all but the facets. All processes call it. Throws
/// Error{io_failed}.
[[nodiscard]] std::vector<std::optional<DistrictResult>> shared_tile(
    std::span<const std::size_t> owners, const Processes& processes, const TileWork& work);

}  // namespace dupin::cli
