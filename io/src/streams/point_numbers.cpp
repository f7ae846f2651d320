#include "streams/point_numbers.h"

#include <algorithm>
#include <map>
#include <string>

#include "dupin/kernel/error.h"

namespace dupin::streams {

std::uint32_t PointNumbers::of(std::uint32_t point) const {
  const auto found = std::ranges::lower_bound(known, std::pair(point, std::uint32_t{0}));
  return found != known.end() && found->first == point
             ? found->second
             : first + point - static_cast<std::uint32_t>(found - known.begin());
}

NumberedPoints numbered_points(const SpilledMeshes& meshes, std::span<const std::size_t> pieces) {
  NumberedPoints result;
  std::map<std::string, std::pair<std::size_t, std::size_t>> begun;  // piece and border
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    PointNumbers& own = result.pieces.emplace_back();
    own.first = static_cast<std::uint32_t>(result.count);
    const std::vector<MeshBorder>& borders = meshes.borders(pieces[i]);
    for (std::size_t k = 0; k < borders.size(); ++k) {
      const auto [entry, is_new] = begun.try_emplace(borders[k].name, i, k);
      if (is_new) {
        continue;
      }
      const auto [before, border] = entry->second;
      own.shared.push_back({k, before, border});
      result.pieces[before].shared.push_back({border, i, k});
      const std::vector<std::uint32_t>& there = meshes.borders(pieces[before])[border].points;
      if (borders[k].points.size() != there.size()) {
        throw Error(Errc::invalid_argument,
                    "the border '" + borders[k].name + "' has " + std::to_string(there.size()) +
                        " points in one piece and " + std::to_string(borders[k].points.size()) +
                        " in another one");
      }
      for (std::size_t point = 0; point < there.size(); ++point) {
        own.known.emplace_back(borders[k].points[point], result.pieces[before].of(there[point]));
      }
    }
    std::ranges::sort(own.known);
    result.count += meshes.points_of(pieces[i]) - own.known.size();
  }
  return result;
}

}  // namespace dupin::streams
