#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "healing/polygon_soup.h"
#include "mesh/edge_table.h"

namespace dupin::healing {

/// Which shells of a soup are around which. The shells are closed; they may touch and cross each
/// other, and share faces. One is around another if this is nowhere outside of it, and they do not
/// bound the same.
class ShellEnclosure {
 public:
  /// `signs`: of the volumes of the shells. Those that are nothing are around nothing.
  ShellEnclosure(const PolygonSoup& soup, const mesh::Shells& shells, std::span<const int> signs);

  /// Ascending.
  [[nodiscard]] std::span<const std::uint32_t> around(std::size_t shell) const {
    return around_[shell];
  }

 private:
  std::vector<std::vector<std::uint32_t>> around_;
};

}  // namespace dupin::healing
