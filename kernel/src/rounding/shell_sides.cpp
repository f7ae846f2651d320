#include "rounding/shell_sides.h"

#include <algorithm>
#include <numeric>

#include "mesh/measure.h"

namespace dupin::rounding {

ShellSides::ShellSides(std::span<const std::uint32_t> shell_of)
    : shell_of_(shell_of.begin(), shell_of.end()), points_(shell_of.size()) {
  std::iota(points_.begin(), points_.end(), 0);
  std::ranges::stable_sort(points_, {}, [&](std::uint32_t point) { return shell_of_[point]; });
  first_.resize(points_.size(), 0);
  for (std::size_t i = points_.size(); i-- > 0;) {
    first_[shell_of_[points_[i]]] = i;
  }
}

bool ShellSides::stay(const EditedMesh& mesh, std::uint32_t from, std::uint32_t to,
                      const Eigen::AlignedBox3d& swept) {
  const std::uint32_t shell = shell_of_[from];
  std::size_t& first = first_[shell];
  while (mesh.faces(points_[first]).empty()) {  // `from` itself is left
    ++first;
  }
  for (std::size_t i = first; i < points_.size() && shell_of_[points_[i]] == shell; ++i) {
    if (!mesh.faces(points_[i]).empty() && !swept.contains(mesh.point(points_[i]))) {
      return true;
    }
  }
  std::vector<Triangle> triangles = triangles_from(mesh, first);
  const int before = mesh::volume_sign({mesh.points(), triangles});
  for (Triangle& t : triangles) {  // those of the edge have no area then
    std::ranges::replace(t, from, to);
  }
  return mesh::volume_sign({mesh.points(), triangles}) == before;
}

/// Those of the shell, of which that is the place of the first point.
std::vector<Triangle> ShellSides::triangles_from(const EditedMesh& mesh, std::size_t first) const {
  const std::uint32_t shell = shell_of_[points_[first]];
  std::vector<Triangle> triangles;
  for (std::size_t i = first; i < points_.size() && shell_of_[points_[i]] == shell; ++i) {
    for (const std::uint32_t face : mesh.faces(points_[i])) {
      if (std::ranges::min(mesh.triangle(face)) == points_[i]) {
        triangles.push_back(mesh.triangle(face));
      }
    }
  }
  return triangles;
}

}  // namespace dupin::rounding
