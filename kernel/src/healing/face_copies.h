#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "healing/polygon_soup.h"

namespace dupin::healing {

struct SettledCopies {
  std::size_t dropped = 0;
  bool has_copies = false;              ///< among those left
  std::vector<std::uint8_t> is_turned;  ///< of each triangle left
  std::vector<std::uint8_t> is_paired;  ///< likewise: copies of it stay that close nothing
};

/// Decides how often each triangle counts, and which way round, so that the surface is closed:
/// drops copies that are too many and turns triangles.
///
/// Copies are triangles of the same corners. Where the triangles as they are run along each edge as
/// often one way as the other, so they stay: copies of opposite orientation cancel, others stay as
/// often as the surface has them; but where all of what hangs together is there several times, once
/// is enough. Elsewhere a triangle counts at most as often as it is there, and at least once unless
/// there are copies that may cancel: both ways, or away from edges that no other triangle has; what
/// hangs together by edges of two different triangles has one orientation, that of most of it, and
/// one count, which is not zero if it ends nowhere; and edges of more settle the rest, the largest
/// such parts first. Where that leaves an opening, counts of single triangles are changed as long
/// as that makes it smaller; and if that does not close it, all of it is tried once more with
/// copies that may cancel anywhere, as long as something is left of what hangs together. If none of
/// it closes the surface, it stays open. `was_turned`: empty, or 1 per triangle that was turned
/// before: such copies are dropped first.
///
/// O(n log n). Throws Error{not_oriented} for what has only one side.
SettledCopies settle_copies(PolygonSoup& soup, std::span<const std::uint8_t> was_turned = {});

/// The same, but copies of opposite orientation both stay where the triangles as they are run along
/// each edge as often one way as the other: they may belong to shells that are turned yet.
SettledCopies close_surface(PolygonSoup& soup);

}  // namespace dupin::healing
