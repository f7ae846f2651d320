#pragma once

#include <algorithm>
#include <array>
#include <map>

#include "healing/polygon_soup.h"

namespace dupin::healing {

inline PolygonSoup soup_of(const TriMesh& mesh) {
  PolygonSoup soup{mesh.points, mesh.triangles, {}};
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    soup.sources.push_back(i);
  }
  return soup;
}

inline std::map<std::array<std::uint32_t, 2>, int> edge_balance(const PolygonSoup& soup) {
  std::map<std::array<std::uint32_t, 2>, int> balance;
  for (const Triangle& t : soup.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  return balance;
}

inline bool is_balanced(const PolygonSoup& soup) {
  return std::ranges::all_of(edge_balance(soup), [](const auto& e) { return e.second == 0; });
}

}  // namespace dupin::healing
