#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

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

using Cell = std::array<int, 3>;

inline std::set<Cell> cells_of_box(const Cell& low, const Cell& high) {
  std::set<Cell> cells;
  for (int x = low[0]; x < high[0]; ++x) {
    for (int y = low[1]; y < high[1]; ++y) {
      for (int z = low[2]; z < high[2]; ++z) {
        cells.insert({x, y, z});
      }
    }
  }
  return cells;
}

/// The surface of unit cubes: what several bodies have of it in common has the same triangles.
inline TriMesh surface_of_cells(const std::set<Cell>& cells) {
  TriMesh mesh;
  for (const Cell& cell : cells) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        Cell beyond = cell;
        beyond[axis] += 2 * side - 1;
        if (cells.contains(beyond)) {
          continue;
        }
        const auto first = static_cast<std::uint32_t>(mesh.points.size());
        for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
          Vec3& point = mesh.points.emplace_back(cell[0], cell[1], cell[2]);
          point[axis] += side;
          point[(axis + 1) % 3] += u;
          point[(axis + 2) % 3] += v;
        }
        for (const std::uint32_t k : {1U, 2U}) {
          mesh.triangles.push_back(side == 1 ? Triangle{first, first + k, first + k + 1}
                                             : Triangle{first, first + k + 1, first + k});
        }
      }
    }
  }
  return mesh;
}

inline TriMesh surface_of_cells(const Cell& low, const Cell& high) {
  return surface_of_cells(cells_of_box(low, high));
}

}  // namespace dupin::healing
