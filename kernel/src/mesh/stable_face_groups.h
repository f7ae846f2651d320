#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "support/none.h"

namespace dupin::exact {
class FloatLattice;
}

namespace dupin::mesh {

/// Classes of triangles that keep apart wherever their points move a little: proved once, where a
/// solid is made of a mesh, and of use wherever it, or what a boolean operation leaves of it, is
/// rounded.
struct StableFaceGroups {
  struct Group {
    double largest;  ///< coordinate of its points, in absolute value; they are doubles
    double reach;    ///< by which each coordinate of each point may move
  };
  static constexpr std::uint32_t kNone = support::kNone;

  std::vector<std::uint32_t> of_triangle;  ///< its class or kNone; empty if there are no classes
  std::vector<Group> classes;
};

/// One class, of the marked triangles, for rounding to binary32.
[[nodiscard]] StableFaceGroups one_group(std::span<const std::uint8_t> marked, double largest);

/// By how much rounding to binary32 moves coordinates that are not above `largest`.
[[nodiscard]] double reach_of_binary32(double largest);

/// The classes of triangles if all keep apart once their points are rounded to a lattice whose
/// steps are not above `step` there; else none. `shifted` tells that the origin is not 0.
[[nodiscard]] std::span<const std::uint32_t> groups_apart(const StableFaceGroups& stable,
                                                          const exact::FloatLattice& lattice,
                                                          double step, bool shifted);

}  // namespace dupin::mesh
