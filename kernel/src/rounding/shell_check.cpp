#include "rounding/shell_check.h"

#include <algorithm>
#include <set>

#include "mesh/self_contact.h"
#include "rounding/fault_tracker.h"
#include "support/blocks.h"
#include "support/sequences.h"

namespace dupin::rounding {

std::vector<std::uint32_t> crossed_contacts(const mesh::MeshView& mesh,
                                            std::span<const std::uint32_t> representatives) {
  std::vector<std::uint8_t> is_shared(representatives.size(), 0);
  for (std::uint32_t point = 0; point < representatives.size(); ++point) {
    if (representatives[point] != point) {
      is_shared[point] = is_shared[representatives[point]] = 1;
    }
  }
  // More than two faces have an edge only where one of its ends is where others are.
  const auto marked = marked_faces(mesh.triangles, is_shared);
  const auto touching =
      support::indices_where(marked.size(), [&](std::uint32_t face) { return marked[face] != 0; });
  const auto triangles = support::selected(mesh.triangles, touching);
  mesh::MeshView view = mesh;
  view.triangles = triangles;
  std::vector<std::uint32_t> crossed;
  for (const mesh::ContactPlace& place : mesh::find_contacts(view, representatives)) {
    if (!place.alternating) {
      for (const std::uint32_t face : place.faces) {
        crossed.push_back(touching[face]);
      }
    }
  }
  return crossed;
}

std::size_t remove_small_shells(EditedMesh& mesh, const std::vector<std::uint32_t>& faces,
                                double reach) {
  std::size_t removed = 0;
  std::set<std::uint32_t> seen;  // faces of shells that have been looked at
  for (const std::uint32_t first : faces) {
    if (!mesh.alive(first) || seen.contains(first)) {
      continue;
    }
    const Vec3 centre = mesh.point(mesh.triangle(first)[0]);
    std::vector<std::uint32_t> shell = {first};
    std::set<std::uint32_t> in_shell = {first};
    bool small = true;
    for (std::size_t i = 0; small && i < shell.size(); ++i) {
      for (const std::uint32_t v : mesh.triangle(shell[i])) {
        small = small && (mesh.point(v) - centre).norm() <= reach;
        for (const std::uint32_t f : mesh.faces(v)) {
          if (in_shell.insert(f).second) {
            shell.push_back(f);
          }
        }
      }
    }
    seen.insert(in_shell.begin(), in_shell.end());
    if (small) {
      mesh.remove(shell);
      ++removed;
    }
  }
  return removed;
}

}  // namespace dupin::rounding
