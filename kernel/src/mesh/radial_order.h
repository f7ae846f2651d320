#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace dupin::mesh {

/// Sorts half-planes around the edge where they all end, counter-clockwise about its direction,
/// beginning with the first; those that coincide keep their order. `turn(a, b)` is +1 if turning
/// counter-clockwise by less than a half turn leads from a to b, -1 if turning clockwise does, 0 if
/// they lie in one plane; of such, `are_opposite(a, b)` tells whether the edge is between them.
template <class HalfPlane, class Turn, class AreOpposite>
void sort_around_edge(std::vector<HalfPlane>& half_planes, const Turn& turn,
                      const AreOpposite& are_opposite) {
  const HalfPlane first = half_planes.front();
  // Coincident with the first, less than a half turn on, a half turn, or more.
  const auto sector = [&](const HalfPlane& h) {
    const int side = turn(first, h);
    return side > 0 ? 1 : side < 0 ? 3 : are_opposite(first, h) ? 2 : 0;
  };
  std::vector<std::pair<int, HalfPlane>> keyed;
  keyed.reserve(half_planes.size());
  for (const HalfPlane& h : half_planes) {
    keyed.emplace_back(keyed.empty() ? 0 : sector(h), h);
  }
  std::stable_sort(keyed.begin(), keyed.end(), [&turn](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first
                              : a.first % 2 == 1 && turn(a.second, b.second) > 0;
  });
  for (std::size_t i = 0; i < half_planes.size(); ++i) {
    half_planes[i] = std::move(keyed[i].second);
  }
}

}  // namespace dupin::mesh
