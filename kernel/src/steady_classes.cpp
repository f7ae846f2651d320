#include "steady_classes.h"

#include <algorithm>

#include "lattice.h"

namespace dupin::detail {

SteadyClasses one_class(std::span<const std::uint8_t> marked, double largest) {
  SteadyClasses steady;
  if (std::ranges::find(marked, 1) != marked.end()) {
    steady.classes = {{largest, reach_of_binary32(largest)}};
    steady.of_triangle.reserve(marked.size());
    for (const std::uint8_t is_marked : marked) {
      steady.of_triangle.push_back(is_marked != 0 ? 0 : SteadyClasses::kNone);
    }
  }
  return steady;
}

double reach_of_binary32(double largest) {
  return Lattice(Coordinates::binary32).step(largest) / 2;
}

std::span<const std::uint32_t> classes_apart(const SteadyClasses& steady, const Lattice& lattice,
                                             double step, bool shifted) {
  const auto stays = [&](const SteadyClasses::Class& one) {
    return (shifted ? step : lattice.step(one.largest)) / 2 <= one.reach;
  };
  return std::ranges::all_of(steady.classes, stays) ? std::span(steady.of_triangle)
                                                    : std::span<const std::uint32_t>();
}

}  // namespace dupin::detail
