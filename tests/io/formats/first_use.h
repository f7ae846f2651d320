#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::test {

/// `mesh` with its points in the order in which its triangles, by label, name them first.
inline TriMesh by_first_use(const TriMesh& mesh) {
  TriMesh sorted{{}, {}, {}, mesh.names};
  std::vector<std::uint32_t> index(mesh.points.size(), std::numeric_limits<std::uint32_t>::max());
  for (std::uint32_t label = 0; label < std::max<std::size_t>(mesh.names.size(), 1); ++label) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (!mesh.labels.empty() && mesh.labels[i] != label) {
        continue;
      }
      Triangle triangle = mesh.triangles[i];
      for (std::uint32_t& corner : triangle) {
        if (index[corner] > mesh.points.size()) {
          index[corner] = static_cast<std::uint32_t>(sorted.points.size());
          sorted.points.push_back(mesh.points[corner]);
        }
        corner = index[corner];
      }
      sorted.triangles.push_back(triangle);
      if (!mesh.labels.empty()) {
        sorted.labels.push_back(label);
      }
    }
  }
  return sorted;
}

}  // namespace dupin::test
