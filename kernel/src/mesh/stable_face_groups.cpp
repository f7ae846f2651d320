#include "mesh/stable_face_groups.h"

#include <algorithm>

#include "exact/float_lattice.h"

namespace dupin::mesh {

StableFaceGroups one_group(std::span<const std::uint8_t> marked, double largest) {
  StableFaceGroups stable;
  if (std::ranges::find(marked, 1) != marked.end()) {
    stable.classes = {{largest, reach_of_binary32(largest)}};
    stable.of_triangle.reserve(marked.size());
    for (const std::uint8_t is_marked : marked) {
      stable.of_triangle.push_back(is_marked != 0 ? 0 : StableFaceGroups::kNone);
    }
  }
  return stable;
}

double reach_of_binary32(double largest) {
  return exact::FloatLattice(Coordinates::binary32).step(largest) / 2;
}

std::span<const std::uint32_t> groups_apart(const StableFaceGroups& stable,
                                            const exact::FloatLattice& lattice, double step,
                                            bool shifted) {
  const auto stays = [&](const StableFaceGroups::Group& one) {
    return (shifted ? step : lattice.step(one.largest)) / 2 <= one.reach;
  };
  return std::ranges::all_of(stable.classes, stays) ? std::span(stable.of_triangle)
                                                    : std::span<const std::uint32_t>();
}

}  // namespace dupin::mesh
