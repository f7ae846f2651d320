#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
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

/// How the districts of a tile are made, the parts of the document that each has, and what becomes
/// of them.
struct TileWork {
  std::function<DistrictResult(std::size_t)> made;
  std::function<std::vector<std::uint32_t>(std::size_t)> parts;
  std::function<void(std::size_t, DistrictResult)> taken;
};

/// Makes the districts of a tile that this process owns, as many at a time as there are threads.
/// All are taken, in order, by every process, which has of those of others all but the facets; one
/// alone takes them while it makes more. All processes call it. Throws Error{io_failed}.
void share_tile(std::span<const std::size_t> owners, const Processes& processes,
                const TileWork& work);

}  // namespace dupin::cli
