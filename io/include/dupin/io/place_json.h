#pragma once

#include <string>
#include <string_view>

#include "dupin/kernel/placement.h"

namespace dupin {

/// A document put elsewhere.
struct PlacedDocument {
  std::string text;
  bool is_exact = true;  ///< every number is what was asked for, without rounding
  /// No point, radius or length is farther from it; directions, which have no length, do not count.
  double largest_move = 0;
};

/// The document `text` with all points placed, directions turned, and lengths, radii and the
/// tolerance changed in size. Each number is the double nearest to the exact one, in the shortest
/// decimals; every other character, and every number that does not change, stays as it was. Ports,
/// names, angles, slopes and weights do not change. Numbers that are equal stay equal, so that ends
/// which meet still do. A document with values, copies, sizes or expressions comes out as
/// document_text writes it. Throws as parse_assembly.
[[nodiscard]] PlacedDocument placed_document(std::string_view text, const std::string& source,
                                             const Placement& placement);

}  // namespace dupin
