#include "sheets.h"

#include <algorithm>

#include "predicates.h"

namespace dupin::detail {
namespace {

// +1 if turning counter-clockwise by less than a half turn leads from `from` to `to`, -1 if turning
// clockwise does, 0 if they are opposite. The front of a sheet that runs forward lies ahead of it.
int ahead(const Scene& scene, const Sheet& from, const Sheet& to) {
  const Triangle& plane = scene.support(from.support);
  const int side = side_of_plane(scene.points, plane[0], plane[1], plane[2], to.apex);
  return from.forward ? side : -side;
}

}  // namespace

void sort_around_edge(const Scene& scene, std::vector<Sheet>& sheets) {
  const Sheet first = sheets.front();
  const auto half_turns = [&](const Sheet& s) {
    const int side = ahead(scene, first, s);
    return side > 0 ? 1 : side == 0 ? 2 : 3;
  };
  std::vector<std::pair<int, Sheet>> keyed;
  for (const Sheet& s : sheets) {
    keyed.emplace_back(keyed.empty() ? 0 : half_turns(s), s);
  }
  std::sort(keyed.begin(), keyed.end(), [&scene](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first
                              : a.first % 2 == 1 && ahead(scene, a.second, b.second) > 0;
  });
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    sheets[i] = keyed[i].second;
  }
}

}  // namespace dupin::detail
