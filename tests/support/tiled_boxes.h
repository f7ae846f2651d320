#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/kernel/mesh.h"

namespace dupin::test {

/// Where a box is cut along each axis, its ends included; ascending.
using Cuts = std::array<std::vector<double>, 3>;

/// A box whose sides are tiled by rectangles, and these divided by one diagonal or the other.
inline TriMesh tiled_box(const Cuts& cuts, std::mt19937& random) {
  TriMesh mesh;
  std::map<std::array<double, 3>, std::uint32_t> index;
  const auto corner = [&](const std::array<double, 3>& at) {
    const auto [found, is_new] = index.try_emplace(at, std::uint32_t(mesh.points.size()));
    if (is_new) {
      mesh.points.emplace_back(at[0], at[1], at[2]);
    }
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool is_high : {false, true}) {
      for (std::size_t i = 0; i + 1 < cuts[u].size(); ++i) {
        for (std::size_t j = 0; j + 1 < cuts[v].size(); ++j) {
          const auto at = [&](std::size_t a, std::size_t b) {
            std::array<double, 3> place{};
            place[axis] = is_high ? cuts[axis].back() : cuts[axis].front();
            place[u] = cuts[u][i + a];
            place[v] = cuts[v][j + b];
            return corner(place);
          };
          std::array<std::uint32_t, 4> ring{at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
          if (!is_high) {
            std::reverse(ring.begin(), ring.end());
          }
          std::rotate(ring.begin(), ring.begin() + long(random() % 2), ring.end());
          mesh.triangles.push_back({ring[0], ring[1], ring[2]});
          mesh.triangles.push_back({ring[2], ring[3], ring[0]});
        }
      }
    }
  }
  return mesh;
}

/// Of so many tiles at most along each edge, on a coarse grid, so that sides of several lie in one
/// plane, and their edges cross, or lie along each other.
inline TriMesh random_tiled_box(std::mt19937& random, int most_tiles = 4) {
  Cuts cuts;
  for (std::vector<double>& along : cuts) {
    const double from = double(random() % 3), to = from + 1 + double(random() % 3);
    along = {from, to};
    for (int i = int(random() % unsigned(most_tiles)); i > 0; --i) {
      along.push_back(from + (to - from) * double(1 + random() % 7) / 8);
    }
    std::sort(along.begin(), along.end());
    along.erase(std::unique(along.begin(), along.end()), along.end());
  }
  return tiled_box(cuts, random);
}

/// Turned about the origin by the same angle as all others, so that sides which had one plane, and
/// edges which had one line, are off it by what rounding has left.
inline TriMesh turned_tiled_box(std::mt19937& random, int most_tiles = 4) {
  TriMesh mesh = random_tiled_box(random, most_tiles);
  const Eigen::AngleAxisd turn(std::sqrt(0.7),
                               Vec3(1, std::sqrt(2.0), std::sqrt(3.0)).normalized());
  for (Vec3& point : mesh.points) {
    point = turn * point;
  }
  return mesh;
}

}  // namespace dupin::test
