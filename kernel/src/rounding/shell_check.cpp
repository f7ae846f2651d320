#include "rounding/shell_check.h"

#include <algorithm>

#include "mesh/self_contact.h"
#include "rounding/edits/fault_tracker.h"
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

}  // namespace dupin::rounding
